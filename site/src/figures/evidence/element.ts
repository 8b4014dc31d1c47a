/**
 * <bugbot-evidence>: one cell to hit and to pass, with its log odds and its probability.
 *
 * The page holds it whole as it was built; the element writes the same text again with its controls
 * enabled, and from then on only what has changed. May import this folder's files.
 */
import { type Press, SYSTEMS, type System } from "./cell.ts";
import { BUTTONS, evidenceHtml, FIRST_PRESSES } from "./html.ts";
import { evidencePicture } from "./picture.ts";
import { evidenceSentence, READOUT, readout, systemSentence } from "./says.ts";

export class BugbotEvidence extends HTMLElement {
  #system: System = "ours";
  #presses: readonly Press[] = FIRST_PRESSES;

  connectedCallback(): void {
    const id = this.id || "evidence";
    const [system, presses] = [this.#system, this.#presses];
    this.innerHTML = evidenceHtml({ system, presses, id, live: true });
    this.#part(".figure-controls").addEventListener("click", (event) => this.#press(event));
    this.#part("select").addEventListener("change", (event) => this.#choose(event));
  }

  #press({ target }: Event): void {
    const button = target instanceof Element ? target.closest("button") : null;
    const what = button?.dataset.do;
    if (what === "undo") this.#presses = this.#presses.slice(0, -1);
    if (what === "again") this.#presses = [];
    for (const [name, { press }] of Object.entries(BUTTONS)) {
      if (name === what) this.#presses = [...this.#presses, press];
    }
    this.#show();
  }

  #choose({ target }: Event): void {
    for (const name of Object.keys(SYSTEMS) as System[]) {
      if (target instanceof HTMLSelectElement && target.value === name) this.#system = name;
    }
    this.#part(".figure-systems p").textContent = systemSentence(this.#system);
    this.#show();
  }

  #show(): void {
    const numbers = SYSTEMS[this.#system];
    const now = readout(numbers, this.#presses);
    this.#part(".picture").innerHTML = evidencePicture(numbers, this.#presses);
    this.#part(".figure-says").textContent = evidenceSentence(numbers, this.#presses);
    for (const name of READOUT) this.#part(`[data-now=${name}]`).textContent = now[name];
    this.#part(".cell").setAttribute("data-call", now.call);
  }

  #part(selector: string): Element {
    const part = this.querySelector(selector);
    if (!part) throw new Error(`<bugbot-evidence> was written without a ${selector}`);
    return part;
  }
}

customElements.define("bugbot-evidence", BugbotEvidence);
