/**
 * <bugbot-beam>: a beam to drag over a grid, and the cells that each rule finds on its way.
 *
 * The page holds it whole as it was built; the element writes the same text again with its controls
 * enabled, and from then on only what has changed. May import this folder's files and `ui`.
 */
import { beamHtml, legendItems, placed } from "./html.ts";
import { beamPicture, onMatOf } from "./picture.ts";
import { beamSentence, place, tally } from "./says.ts";
import {
  type Beam,
  CELL_CM,
  EXAMPLES,
  FIRST_RULE,
  HIGH_CM,
  onMat,
  RULES,
  type Rule,
  WIDE_CM,
} from "./scene.ts";

const ARROWS: Readonly<Record<string, readonly [right: number, up: number]>> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export class BugbotBeam extends HTMLElement {
  #beam: Beam = EXAMPLES.slant;
  #rule: Rule = FIRST_RULE;
  #dragged: keyof Beam | null = null;

  connectedCallback(): void {
    const id = this.id || "beam";
    this.innerHTML = beamHtml({ beam: this.#beam, rule: this.#rule, id, live: true });
    const handles = this.#part<SVGElement>(".handles");
    handles.addEventListener("pointerdown", (event) => this.#take(event));
    // `touch-action` does not hold for what is inside an SVG, and the page would scroll away.
    handles.addEventListener(
      "touchstart",
      (event) => handleOf(event.target) && event.preventDefault(),
      { passive: false },
    );
    handles.addEventListener("pointermove", (event) => this.#drag(event));
    handles.addEventListener("pointerup", () => this.#let());
    handles.addEventListener("pointercancel", () => this.#let());
    handles.addEventListener("keydown", (event) => this.#key(event));
    this.#part(".figure-rules").addEventListener("change", (event) => this.#choose(event));
    this.#part(".figure-controls").addEventListener("click", (event) => this.#example(event));
  }

  // -- what a person does ----------------------------------------------------------

  #take(event: PointerEvent): void {
    const handle = handleOf(event.target);
    if (!handle || event.button !== 0) return;
    // Beyond the figure's edge the pointer is still the handle's.
    handle.setPointerCapture(event.pointerId);
    this.#dragged = whichOf(handle);
    handle.focus({ preventScroll: true });
    event.preventDefault();
  }

  #drag(event: PointerEvent): void {
    if (!this.#dragged) return;
    const { left, top, width, height } = this.#part(".handles").getBoundingClientRect();
    const x = ((event.clientX - left) / width) * WIDE_CM;
    const y = ((event.clientY - top) / height) * HIGH_CM;
    this.#move(this.#dragged, onMatOf({ x, y }));
  }

  #let(): void {
    this.#dragged = null;
  }

  #key(event: KeyboardEvent): void {
    const handle = handleOf(event.target);
    const arrow = ARROWS[event.key];
    if (!handle || !arrow || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    const which = whichOf(handle);
    const by = event.shiftKey ? CELL_CM : 1;
    const { x, y } = this.#beam[which];
    this.#move(which, { x: x + by * arrow[0], y: y + by * arrow[1] });
  }

  #choose({ target }: Event): void {
    const rule = RULES.find((each) => target instanceof HTMLInputElement && each === target.value);
    if (!rule) return;
    this.#rule = rule;
    this.#show();
  }

  #example({ target }: Event): void {
    const button = target instanceof Element ? target.closest("button") : null;
    for (const [name, beam] of Object.entries(EXAMPLES)) {
      if (name !== button?.dataset.example) continue;
      this.#beam = beam;
      this.#show();
    }
  }

  #move(which: keyof Beam, to: { x: number; y: number }): void {
    this.#beam = { ...this.#beam, [which]: onMat(to) };
    this.#show();
  }

  // -- what is shown -----------------------------------------------------------------

  #show(): void {
    const [beam, rule] = [this.#beam, this.#rule];
    this.#part(".picture").innerHTML = beamPicture(beam, rule);
    this.#part(".figure-legend").innerHTML = legendItems(beam, rule);
    this.#part(".figure-says").textContent = beamSentence(beam, rule);
    for (const each of RULES) this.#part(`[data-tally=${each}]`).textContent = tally(beam, each);
    for (const which of ["start", "end"] as const) {
      const handle = this.#part(`[data-handle=${which}]`);
      handle.setAttribute("transform", placed(beam, which));
      handle.setAttribute("aria-valuenow", String(beam[which].x));
      handle.setAttribute("aria-valuetext", place(beam, which));
    }
  }

  #part<Part extends Element>(selector: string): Part {
    const part = this.querySelector<Part>(selector);
    if (!part) throw new Error(`<bugbot-beam> was written without a ${selector}`);
    return part;
  }
}

function handleOf(target: EventTarget | null): SVGElement | null {
  return target instanceof Element ? target.closest<SVGElement>("[data-handle]") : null;
}

function whichOf(handle: SVGElement): keyof Beam {
  return handle.dataset.handle === "start" ? "start" : "end";
}

customElements.define("bugbot-beam", BugbotBeam);
