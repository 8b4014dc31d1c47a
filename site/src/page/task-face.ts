/**
 * What a task looks like, drawn from its state; what a person does to it goes to the handlers.
 * May import `runtime`, `trace` and `ui`.
 */
import { html, nothing, type TemplateResult } from "lit";
import { icons } from "../ui/icons.ts";
import { hintWords, solutionWords, taskWords } from "../ui/task-words.ts";
import type { TaskData } from "./lesson-data.ts";
import type { CardInput } from "./results-card.ts";
import { type ChecksInput, checkList } from "./task-checks.ts";
import { type MarkStatusInput, markStatus } from "./task-status.ts";
import "./task.css";

export interface TaskFace {
  name: string;
  data: TaskData;
  /** The nodes of the page that the element has taken over. */
  title: Element;
  statement: Element;
  hints: readonly Element[];
  /** Which of the lesson's tasks it is, 1 first. */
  number: number;
  of: number;
  state: "new" | "tried" | "passed";
  /** It has been passed just now: the sign of it is drawn, not only shown. */
  fresh: boolean;
  status: MarkStatusInput;
  /** Null before the first mark. */
  checks: ChecksInput | null;
  /** Null if the mark reports no runs. */
  results: CardInput | null;
  /** The mark is for another program than the one in the editor. */
  stale: boolean;
  opened: number;
  solution: "closed" | "warned";
  /** Something was done to the program, and can be undone. */
  note: { text: string; undo: (() => void) | null } | null;
  /** The task to go on with, once this one is passed. */
  next: { name: string; title: string } | null;
  onOpenHint(): void;
  onSolution(): void;
}

export function taskFace(face: TaskFace): TemplateResult {
  const { name, data, state, title, statement } = face;
  return html`<article class="task" aria-labelledby=${title.id} data-state=${state}>
    <header class="task-head">
      <p class="task-place">
        ${taskWords.place(face.number, face.of)}
        ${data.stretch ? html`<span class="task-stretch">${taskWords.stretch}</span>` : nothing}
      </p>
      ${title}
      <p class="task-state" ?data-fresh=${face.fresh}>
        ${STATE_ICONS[state]}<span>${taskWords.states[state]}</span>
      </p>
    </header>
    ${statement}
    <bugbot-lab
      id="lab-task-${name}"
      label=${data.title}
      world=${data.world}
      ?pickers=${(data.practice ?? []).length > 0}
      .choices=${[data.world, ...(data.practice ?? [])]}
      seed=${data.seed}
      program=${data.starter}
    ></bugbot-lab>
    <div class="task-panel">
      ${markStatus(face.status)}
      ${
        face.checks
          ? html`<div class="task-marks" ?data-stale=${face.stale}>
              ${checkList(face.checks)} ${resultsOf(face)}
            </div>`
          : nothing
      }
      ${openHints(face)} ${foot(face)}
    </div>
  </article>`;
}

/** The element is known once there are results to show. */
function resultsOf({ results }: TaskFace): TemplateResult | typeof nothing {
  return results ? html`<results-card .input=${results}></results-card>` : nothing;
}

const STATE_ICONS = { new: icons.notTried, tried: icons.tried, passed: icons.passed };

function openHints({ hints, opened }: TaskFace): TemplateResult | typeof nothing {
  if (opened === 0) return nothing;
  return html`<section class="task-hints" aria-label=${hintWords.region}>
    ${hints.slice(0, opened).map(
      (hint, i) => html`<div class="task-hint" tabindex="-1">
        <p class="hint-title">${hintWords.title(i + 1, hints.length)}</p>
        ${hint}
      </div>`,
    )}
  </section>`;
}

function foot(face: TaskFace): TemplateResult {
  const { hints, opened, solution, note, next } = face;
  return html`<div class="task-foot">
    ${
      opened < hints.length
        ? html`<button type="button" class="open-hint" @click=${face.onOpenHint}>
            ${hintWords.open(opened + 1, hints.length)}
          </button>`
        : nothing
    }
    <button type="button" class="solution" @click=${face.onSolution}>
      ${solution === "warned" ? solutionWords.showAnyway : solutionWords.show}
    </button>
    <p class="task-note" role="status">
      ${solution === "warned" ? solutionWords.warning : (note?.text ?? nothing)}
    </p>
    ${
      note?.undo
        ? html`<button type="button" @click=${note.undo}>${solutionWords.undo}</button>`
        : nothing
    }
    ${
      next
        ? html`<a class="button task-next" href="#task-${next.name}">${taskWords.next(next.title)}</a>`
        : nothing
    }
  </div>`;
}
