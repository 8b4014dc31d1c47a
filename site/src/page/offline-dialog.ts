/**
 * The panel "Use offline": whether the site works without a network on this device, how far it is
 * on the way there, how much room it takes, and how to be rid of it. May import `ui`.
 */
import { files } from "virtual:python-files";
import { html, nothing, type TemplateResult } from "lit";
import type { KeeperStatus } from "../offline/messages.ts";
import { NO_ROOM } from "../offline/site-files.ts";
import { Dialog } from "../ui/dialog.ts";
import { megabytes } from "../ui/dom.ts";
import { offlineWords as words } from "../ui/offline-words.ts";
import "./offline-dialog.css";
import { watch } from "./offline.ts";
import { keep, obstacle, remove, status } from "./offline-keeper.ts";

/** What all programs need; it is most of what is kept. */
const PYTHON_BYTES = [files.interpreter, files.snapshot, files.sources, files.stdlib].reduce(
  (sum, { bytes }) => sum + bytes,
  0,
);
/** How often it looks how far the fetching is [ms]. */
const LOOK_MS = 400;

export async function showDialog(root: string): Promise<void> {
  const hindered = obstacle();
  if (hindered) {
    new Dialog<never>(words.title).show(html`<p>${words[hindered]}</p>`);
    return;
  }
  await new OfflinePanel(root).open();
}

class OfflinePanel {
  readonly #root: string;
  readonly #dialog = new Dialog<never>(words.title);
  /** What came of the last thing the reader asked for. */
  #said = "";
  /** Kept by this panel's own wish, so a status without one means "just begun". */
  #working = false;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(root: string) {
    this.#root = root;
    this.#dialog.element.classList.add("narrow", "offline-panel");
    void this.#dialog.answered.then(() => clearTimeout(this.#timer));
  }

  async open(): Promise<void> {
    await this.#draw();
    const look = async (): Promise<void> => {
      await this.#draw();
      if (this.#dialog.element.isConnected) this.#timer = setTimeout(look, LOOK_MS);
    };
    this.#timer = setTimeout(look, LOOK_MS);
  }

  async #draw(): Promise<void> {
    const [now, promised] = await Promise.all([
      status(this.#root),
      navigator.storage?.persisted?.() ?? false,
    ]);
    this.#dialog.show(now ? this.#kept(now, promised) : this.#nothing());
  }

  #nothing(): TemplateResult {
    return html`<p>${this.#working ? words.partly : words.begin(megabytes(PYTHON_BYTES))}</p>
      ${this.#working ? html`<progress aria-label=${words.title}></progress>` : nothing}
      <footer>
        <p role="status">${this.#said}</p>
        ${
          this.#working
            ? nothing
            : html`<button type="button" class="go" @click=${() => this.#keep()}>
                ${words.keep}
              </button>`
        }
      </footer>`;
  }

  #kept({ parts, busy, problem }: KeeperStatus, promised: boolean): TemplateResult {
    const { site, python, numpy } = parts;
    const [have, of] = [site.have + python.have, site.of + python.of];
    const whole = have === of;
    const working = busy || this.#working;
    return html`
      <p class="state" data-whole=${whole}>
        <b>${whole ? words.ready : words.partly}</b>
        ${whole ? words.readyToo : words.keeping(megabytes(have), megabytes(of))}
        ${numpy.have === numpy.of ? words.numpyHere : words.numpyNot(megabytes(numpy.of))}
      </p>
      ${
        whole
          ? nothing
          : html`<progress aria-label=${words.title} max=${of} .value=${have}></progress>`
      }
      <p>
        ${words.size(megabytes(have + numpy.have))} ${promised ? words.promised : words.mayClear}
        ${
          promised
            ? nothing
            : html`<button type="button" class="link" @click=${() => this.#promise()}>
                ${words.ask}</button
              >.`
        }
      </p>
      <p>${words.untouched}</p>
      <footer>
        <p role="status">${problem ? problemIn(problem) : this.#said}</p>
        ${this.#button(words.remove, false, () => this.#remove())}
        ${
          whole && numpy.have < numpy.of
            ? this.#button(words.numpyKeep, working, () => this.#keep(true))
            : nothing
        }
        ${whole ? nothing : this.#button(words.goOn, working, () => this.#keep())}
      </footer>
    `;
  }

  #button(label: string, disabled: boolean, act: () => Promise<void>): TemplateResult {
    return html`<button type="button" ?disabled=${disabled} @click=${act}>${label}</button>`;
  }

  async #keep(withNumpy = false): Promise<void> {
    this.#said = "";
    this.#working = true;
    void this.#draw();
    try {
      // The reader has just said that it should stay: the moment to ask the browser the same.
      await navigator.storage?.persist?.();
      await keep(this.#root, withNumpy);
      await watch(this.#root);
    } catch (error) {
      this.#said = problemIn(error instanceof Error ? error.message : String(error));
    }
    this.#working = false;
    await this.#draw();
  }

  async #promise(): Promise<void> {
    const promised = await navigator.storage?.persist?.();
    this.#said = promised ? "" : words.refused;
    await this.#draw();
  }

  async #remove(): Promise<void> {
    await remove(this.#root);
    this.#said = words.removed;
    await this.#draw();
  }
}

function problemIn(what: string): string {
  return what === NO_ROOM ? words.noRoom : words.problem(what);
}
