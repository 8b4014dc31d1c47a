/**
 * The note at the foot of a page of which something is missing. It brings its own look: the site's
 * style sheet may be what is missing. May import `offline/drop` and the words.
 */
import { dropOfflineCopy } from "../offline/drop.ts";
import { earlyWords as words } from "./words.ts";

const LOOK =
  "position:fixed;inset:auto 0 0;z-index:99;display:flex;flex-wrap:wrap;gap:8px 12px;align-items:center;" +
  "padding:12px 16px;font:16px/1.45 system-ui,sans-serif;background:Canvas;color:CanvasText;" +
  "border-top:3px solid #c8402f;box-shadow:0 -4px 16px #0004;color-scheme:";

export class Note {
  readonly #page: Document;
  #element: HTMLElement | null = null;

  constructor(page: Document) {
    this.#page = page;
  }

  /** Says something, in place of what it said before; a page that has just begun, a moment later. */
  show(sentences: readonly string[]): void {
    this.hide();
    if (!this.#page.body) {
      this.#page.addEventListener("DOMContentLoaded", () => this.show(sentences), { once: true });
      return;
    }
    const note = this.#page.createElement("div");
    note.className = "not-loaded";
    note.setAttribute("role", "alert");
    note.style.cssText = LOOK + (this.#page.documentElement.dataset.theme ?? "light dark");
    const text = this.#page.createElement("p");
    text.style.cssText = "flex:1 1 22em;margin:0";
    text.textContent = sentences.filter(Boolean).join(" ");
    note.append(
      text,
      this.#button(words.reload, () => location.reload()),
    );
    // A page that came from the device may have come from a damaged copy.
    if (navigator.serviceWorker?.controller) {
      note.append(
        this.#button(words.without, () => void dropOfflineCopy().then(() => location.reload())),
      );
    }
    note.append(this.#button(words.close, () => this.hide()));
    this.#page.body.append(note);
    this.#element = note;
  }

  hide(): void {
    this.#element?.remove();
    this.#element = null;
  }

  #button(label: string, act: () => void): HTMLElement {
    const button = this.#page.createElement("button");
    button.type = "button";
    button.textContent = label;
    button.onclick = act;
    return button;
  }
}
