/**
 * Watches over what a page loads: scripts, style sheets, the page itself, and the parts that are
 * fetched later (`ui/part.ts`). What does not arrive is tried once more; then the reader is told, with
 * a reason where one can be found, and a button that reloads. Of `embed` it imports what a page
 * around this one is told.
 */
import { MISSING } from "../embed/messages.ts";
import { Note } from "./note.ts";
import { earlyWords as words } from "./words.ts";

/** A page that has not come up by then says that it is waiting [ms]. */
const SLOW_MS = 20_000;
/** The build ends every page with the element of this id, and every style sheet with its rule. */
const END = "whole";

export class Arrivals {
  readonly #page: Document;
  readonly #note: Note;
  /** Style sheets that have been tried again, by address. */
  readonly #again = new Set<string>();
  #isUp = false;
  #hasTold = false;
  #isTelling = false;

  constructor(page: Document) {
    this.#page = page;
    this.#note = new Note(page);
  }

  watch(): void {
    const page = this.#page;
    page.addEventListener("error", ({ target }) => this.#onSheet(target, false), true);
    page.addEventListener("load", ({ target }) => this.#onSheet(target, true), true);
    page.addEventListener("bugbot-up", () => this.#up());
    page.addEventListener("bugbot-missing", (event) => {
      void this.#tell(addressIn((event as CustomEvent<string>).detail));
    });
    page.addEventListener("DOMContentLoaded", () => {
      // It says that scripts do not run. They do, even where the style that hides it is missing.
      for (const notice of page.querySelectorAll(".no-scripts")) notice.remove();
      if (!page.getElementById(END)) void this.#tell(null, words.cut);
    });
    addEventListener("load", () => void this.#bringUp());
    setTimeout(() => {
      if (this.#isUp || this.#hasTold) return;
      this.#note.show([words.slow, ...remedy()]);
    }, SLOW_MS);
  }

  /** The page's own scripts run, all of them. */
  #up(): void {
    this.#isUp = true;
    // It has been slow, no more.
    if (!this.#hasTold) this.#note.hide();
  }

  #onSheet(target: EventTarget | null, arrived: boolean): void {
    if (!(target instanceof HTMLLinkElement) || target.rel !== "stylesheet") return;
    if (arrived && isWhole(target)) return;
    const [address = ""] = target.href.split("?");
    if (this.#again.has(address)) {
      void this.#tell(address);
      return;
    }
    this.#again.add(address);
    const second = target.cloneNode() as HTMLLinkElement;
    // Another address, so that no cache has an answer.
    second.href = `${address}?again`;
    target.after(second);
  }

  /** All that the page names has arrived or failed: what has failed is asked for again. */
  async #bringUp(): Promise<void> {
    const scripts = this.#page.querySelectorAll<HTMLScriptElement>("script[type=module][src]");
    for (const { src } of scripts) {
      if (this.#isUp) return;
      try {
        await import(/* @vite-ignore */ src);
      } catch (error) {
        // What stands in the page for readers without scripts is all there is.
        delete this.#page.documentElement.dataset.scripts;
        await this.#tell(addressIn(String(error)) ?? src);
        return;
      }
    }
    if (!this.#isUp) await this.#tell(null);
  }

  async #tell(address: string | null, what = words.part): Promise<void> {
    if (this.#isTelling) return;
    this.#hasTold = true;
    this.#isTelling = true;
    this.#note.show([what, ...remedy()]);
    const reason = await reasonFor(address);
    if (reason) this.#note.show([what, reason, ...remedy()]);
    if (!this.#isUp) parent.postMessage(MISSING + (reason ? `${what} ${reason}` : what), "*");
    // Something else may go missing once this has been put away.
    this.#isTelling = false;
  }
}

function remedy(): string[] {
  try {
    localStorage.setItem("bugbot:try", "");
    localStorage.removeItem("bugbot:try");
    return [words.remedy, words.kept];
  } catch {
    return [words.remedy];
  }
}

function isWhole({ href, sheet }: HTMLLinkElement): boolean {
  // The development server's sheets are as they were written.
  if (!href.includes("/assets/")) return true;
  const last = sheet?.cssRules[sheet.cssRules.length - 1];
  return last instanceof CSSStyleRule && last.selectorText === `#${END}`;
}

/** Browsers name the file that a module lacks in their words for it. */
function addressIn(text: string): string | null {
  return /https?:[^\s'"]+/.exec(text)?.[0] ?? null;
}

/** Why a file can't be had, in words; null if there is nothing more to say. */
async function reasonFor(address: string | null): Promise<string | null> {
  if (location.protocol === "file:") return words.file;
  if (!address) return null;
  const name = address.split(/[?#]/)[0]?.split("/").at(-1) ?? "";
  try {
    // Past every cache: a damaged copy there gives way to what the server has.
    const { status, ok, headers } = await fetch(address, { cache: "reload" });
    if (status === 404 || status === 410) return words.gone;
    if (!ok) return words.status(name, status);
    const type = headers.get("Content-Type") ?? "";
    const wanted = name.endsWith(".css") ? "text/css" : "text/javascript";
    const fits = name.endsWith(".css")
      ? /^text\/css/
      : /^(text|application)\/(x-)?(java|ecma)script/;
    return fits.test(type) ? null : words.type(name, type, wanted);
  } catch {
    return navigator.onLine ? null : words.offline;
  }
}
