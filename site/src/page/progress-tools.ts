/**
 * <progress-tools>: saves the progress kept on this device as a file, opens such a file, and clears
 * it. `defineProgressTools` makes it known. May import `ui`.
 */
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { progressWords as words } from "../ui/progress-words.ts";
import { type Progress, ProgressError } from "./progress.ts";
import "./progress-tools.css";
import { chooseFile, decodeText, saveFile } from "./text-file.ts";

/** Far more than the progress of any course takes. */
const MOST_BYTES = 2_000_000;

class ProgressTools extends LitElement {
  readonly #progress: Progress;
  #said = "";
  #undo: (() => void) | null = null;
  readonly #redraw = (): void => this.requestUpdate();

  constructor(progress: Progress) {
    super();
    this.#progress = progress;
  }

  /** In the page itself, not in a shadow: one style sheet. */
  override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.setAttribute("role", "group");
    this.setAttribute("aria-label", words.region);
    this.#progress.addEventListener("change", this.#redraw);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#progress.removeEventListener("change", this.#redraw);
  }

  override render(): TemplateResult {
    const { empty, kept } = this.#progress;
    return html`
      <div class="buttons">
        <button type="button" ?disabled=${empty} @click=${this.#save}>${words.save}</button>
        <button type="button" @click=${this.#open}>${words.open}</button>
        <button type="button" ?disabled=${empty} @click=${this.#clear}>${words.clear}</button>
      </div>
      <div class="said">
        <p role="status">${this.#said}</p>
        ${
          this.#undo
            ? html`<button type="button" @click=${this.#bringBack}>${words.undo}</button>`
            : nothing
        }
      </div>
      ${kept ? nothing : html`<p class="notice">${words.notKept}</p>`}
    `;
  }

  #say(text: string, undo: (() => void) | null = null): void {
    this.#said = text;
    this.#undo = undo;
    this.requestUpdate();
  }

  #save(): void {
    saveFile(words.fileName, this.#progress.export(), "application/json");
    this.#say(words.saved);
  }

  async #open(): Promise<void> {
    const file = await chooseFile(".json,application/json");
    if (!file) return;
    try {
      this.#say(words.opened(this.#progress.import(await textOf(file)).added));
    } catch (error) {
      if (!(error instanceof ProgressError)) throw error;
      this.#say(words.notFile(file.name, error.message));
    }
  }

  #clear(): void {
    this.#say(words.cleared, this.#progress.clear());
    // The button that was pressed can't be pressed again, so the focus goes to what takes it back.
    void this.updateComplete.then(() => this.querySelector<HTMLElement>(".said button")?.focus());
  }

  #bringBack(): void {
    this.#undo?.();
    this.#say(words.back);
    void this.updateComplete.then(() => this.querySelector<HTMLElement>("button")?.focus());
  }
}

async function textOf(file: File): Promise<string> {
  if (file.size > MOST_BYTES) throw new ProgressError(words.tooLarge);
  const text = decodeText(new Uint8Array(await file.arrayBuffer()));
  if (text === null) throw new ProgressError(words.noText);
  return text;
}

export function defineProgressTools(progress: Progress): void {
  customElements.define(
    "progress-tools",
    class extends ProgressTools {
      constructor() {
        super(progress);
      }
    },
  );
}
