/**
 * A panel over the page that asks something: the browser's own modal dialog, which holds the focus,
 * closes with Esc, and gives the focus back. Imports the words of this room.
 */
import { html, render, type TemplateResult } from "lit";
import "./dialog.css";
import { dialogWords } from "./file-words.ts";
import { icons } from "./icons.ts";

let dialogs = 0;

export class Dialog<Answer> {
  /** What was chosen; null if the panel was closed without choosing. */
  readonly answered: Promise<Answer | null>;
  readonly element = document.createElement("dialog");
  readonly #title: string;
  readonly #id = `dialog-${++dialogs}`;
  #answer: Answer | null = null;

  constructor(title: string) {
    this.#title = title;
    const { element } = this;
    element.className = "panel";
    element.setAttribute("aria-labelledby", this.#id);
    element.addEventListener("click", (event) => {
      // The dialog itself is hit only beside its content: on what lies behind it.
      if (event.target === element) element.close();
    });
    this.answered = new Promise((resolve) => {
      element.addEventListener("close", () => {
        element.remove();
        resolve(this.#answer);
      });
    });
  }

  /** Draws the panel; opens it the first time. */
  show(content: TemplateResult): void {
    const { element } = this;
    render(
      html`<div class="panel-inside">
        <header>
          <h2 id=${this.#id}>${this.#title}</h2>
          <button type="button" aria-label=${dialogWords.close} @click=${() => element.close()}>
            ${icons.close}
          </button>
        </header>
        ${content}
      </div>`,
      element,
    );
    if (element.isConnected) return;
    document.body.append(element);
    element.showModal();
  }

  answer(answer: Answer): void {
    this.#answer = answer;
    this.element.close();
  }

  /** Where something that is no template goes. */
  part(selector: string): HTMLElement {
    const part = this.element.querySelector<HTMLElement>(selector);
    if (!part) throw new Error(`the panel "${this.#title}" has no ${selector}`);
    return part;
  }
}
