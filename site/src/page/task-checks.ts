/**
 * The list of a mark's checks, the first that failed opened: what was expected, what happened,
 * where, what it looks like, and what helps. May import `runtime`, `trace` and `ui`.
 */
import { html, nothing, type TemplateResult } from "lit";
import type { CheckMark, Mark, Where } from "../runtime/marks.ts";
import type { Cell } from "../trace/frames.ts";
import { icons } from "../ui/icons.ts";
import { markWords, whereWords } from "../ui/task-words.ts";
import type { Shown } from "./marking.ts";
import "./task-where.ts";

/** So many cells are named one by one to those who can't see them outlined. */
const MOST_NAMED = 20;

export interface ChecksInput {
  mark: Mark;
  shown(where: Where): Shown;
  /** Hints that are open, and how many there are. */
  hints: { opened: number; of: number };
  /** Shows the run or, if there was none, the place in the lab. */
  onShow(where: Where): void;
  onNextHint(): void;
  onHint(index: number): void;
}

export function checkList(input: ChecksInput): TemplateResult {
  const { checks } = input.mark;
  const first = checks.find(({ status }) => status === "failed");
  return html`<ol class="task-checks" aria-label=${markWords.checks}>
    ${checks.map(
      (check, i) => html`<li data-status=${check.status} style="--place: ${i}">
        <p class="check-line">
          ${ICONS[check.status]}
          <span class="check-title">${check.title}</span>
          <span class="check-state">${markWords.state[check.status]}</span>
        </p>
        ${check === first ? failure(check, input) : nothing}
      </li>`,
    )}
  </ol>`;
}

const ICONS = { passed: icons.passed, failed: icons.failed, "not run": icons.notRun };

function failure(check: CheckMark, input: ChecksInput): TemplateResult {
  const { expected, got, likely, where } = check;
  return html`<div class="check-why">
    <dl>
      ${detail(markWords.expected, expected)} ${detail(markWords.got, got)}
      ${likely ? detail(markWords.likely, likely, "likely") : nothing}
    </dl>
    ${where ? place(where, input) : nothing}
    <p class="check-help">${where ? showButton(where, input) : nothing} ${hintButton(check, input)}</p>
  </div>`;
}

function detail(name: string, text: string | null, kind = "value"): TemplateResult {
  return text === null
    ? html``
    : html`<div class=${kind}>
        <dt>${name}</dt>
        <dd>${text}</dd>
      </div>`;
}

// -- where on the mat ----------------------------------------------------------------

export function cellsOf({ cells, cell_cm: size }: Where): Cell[] {
  return cells.map(([column, row]) => ({ x: column * size, y: row * size, size }));
}

/** Where it failed, in words: the world, the moment, the cells. */
function placeWords({ world, seconds, cells }: Where, isRun: boolean): string {
  const moment = seconds === null ? whereWords.atEnd : whereWords.atTime(seconds);
  const outlined = cells.length > 0 ? whereWords.cells(cells.length) : whereWords.noCells;
  return `${whereWords.onWorld(world.title)}${isRun ? moment : ""}${outlined}`;
}

function place(where: Where, input: ChecksInput): TemplateResult {
  const { trace, isRun } = input.shown(where);
  const words = placeWords(where, isRun);
  const list = where.cells.length > 0 ? ` ${whereWords.cellList(where.cells, MOST_NAMED)}` : "";
  return html`<figure class="check-where">
    <task-where
      .run=${trace}
      .time=${where.seconds ?? trace.duration}
      .cells=${cellsOf(where)}
      .label=${`${whereWords.picture}. ${words}${list}`}
    ></task-where>
    <figcaption>${words}</figcaption>
  </figure>`;
}

function showButton(where: Where, input: ChecksInput): TemplateResult {
  const label = input.shown(where).isRun ? whereWords.show : whereWords.showMat;
  return html`<button type="button" @click=${() => input.onShow(where)}>${label}</button>`;
}

// -- what helps ------------------------------------------------------------------------

/** The next hint; or, if the one that helps is open already, the way to it. */
function hintButton({ hint }: CheckMark, input: ChecksInput): TemplateResult | typeof nothing {
  const { opened, of } = input.hints;
  if (hint !== null && hint < opened) {
    return html`<button type="button" @click=${() => input.onHint(hint)}>
      ${markWords.toHint(hint + 1)}
    </button>`;
  }
  if (opened >= of) return nothing;
  return html`<button type="button" @click=${input.onNextHint}>${markWords.nextHint}</button>`;
}
