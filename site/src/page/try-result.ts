/**
 * <try-result>: what has come of a Try button, beside the words it stands in: the reader need not
 * leave them to see it. May import `trace` and `ui`.
 */
import { html, LitElement, nothing, type TemplateResult } from "lit";
import type { Trace } from "../trace/trace.ts";
import { labWords } from "../ui/strings.ts";
import { tryWords } from "../ui/try-words.ts";
import { endWords } from "./status.ts";
import "./task-where.ts";
import { triedFigures } from "./try-figures.ts";

/** An experiment that has ended, however it did. */
export interface Tried {
  /** What was changed, or why nothing could be. */
  words: string;
  /** Null if it could not be run. */
  trace: Trace | null;
  /** The run without it; null if there is none to compare with. */
  before: Trace | null;
  /** Whether there is anything to undo. */
  changed: boolean;
}

export class TryResult extends LitElement {
  static override properties = {
    tried: { attribute: false },
    words: { attribute: false },
    lab: { attribute: false },
  };
  /** What is shown; null while it runs, and when it has been undone. */
  declare tried: Tried | null;
  /** What is said instead. */
  declare words: string;
  /** The lab's id. */
  declare lab: string;
  declare onUndo: () => void;

  constructor() {
    super();
    this.tried = null;
    this.words = tryWords.running;
    this.lab = "";
    this.onUndo = () => {};
  }

  /** In the page itself, not in a shadow: one style sheet. */
  override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.setAttribute("role", "group");
    this.setAttribute("aria-label", tryWords.result);
  }

  override render(): TemplateResult {
    const { tried } = this;
    return html`${tried?.trace ? maps(tried.trace, tried.before) : nothing}
      <div class="told">
        <p role="status">${tried ? told(tried) : this.words}</p>
        <p class="next">
          <a href="#${this.lab}">${tryWords.seeInLab}</a>
          ${
            tried?.changed
              ? html`<button type="button" @click=${() => this.onUndo()}>${labWords.undo}</button>`
              : nothing
          }
        </p>
      </div>`;
  }
}

function told({ words, trace, before }: Tried): TemplateResult {
  const figures = trace ? triedFigures(trace, before) : [];
  return html`<b>${words}</b> ${trace?.end ? endWords(trace.end, trace.fault) : nothing}
    ${figures.map((figure) => html` <span>${tryWords.figure(figure)}</span>`)}`;
}

function maps(trace: Trace, before: Trace | null): TemplateResult {
  const both = [
    ...(before ? [{ run: before, words: tryWords.before }] : []),
    { run: trace, words: tryWords.now },
  ];
  return html`<div class="maps">
    ${both.map(
      ({ run, words }) => html`<figure>
        <task-where
          .run=${run}
          .time=${run.duration}
          .cells=${[]}
          .label=${tryWords.mapOf(words)}
        ></task-where>
        <figcaption>${words}</figcaption>
      </figure>`,
    )}
  </div>`;
}

customElements.define("try-result", TryResult);
