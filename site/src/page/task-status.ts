/**
 * The line under a task's lab: the button that marks, how far marking is, and the mark.
 *
 * It is always there, so nothing moves when a mark comes. What is read out by a screen reader (role
 * status) changes only when something has happened, never while a number counts. May import
 * `runtime` and `ui`.
 */
import { html, nothing, type TemplateResult } from "lit";
import type { MarkProgress } from "../runtime/client.ts";
import type { Mark } from "../runtime/marks.ts";
import { icons } from "../ui/icons.ts";
import { markWords } from "../ui/task-words.ts";
import type { MarkingPhase } from "./marking.ts";
import type { TaskRecord } from "./progress-record.ts";

export interface MarkStatusInput {
  phase: MarkingPhase;
  /** Python is up. */
  ready: boolean;
  progress: MarkProgress | null;
  /** What the marking waits for, in words. */
  waits: string | null;
  mark: Mark | null;
  stale: boolean;
  /** A fault of ours: what is known of it. */
  error: string | null;
  /** How the task stood before this visit. */
  before: TaskRecord | null;
  onCheck(): void;
  onCancel(): void;
}

type Tone = "quiet" | "busy" | "good" | "bad";

export function markStatus(input: MarkStatusInput): TemplateResult {
  const { phase, progress, error, onCheck, onCancel } = input;
  const { tone, text } = say(input);
  const marking = phase === "marking";
  return html`<div class="task-status" data-tone=${tone}>
      <button
        type="button"
        class="check"
        title=${markWords.checkKeys}
        aria-keyshortcuts="Control+Shift+Enter Meta+Shift+Enter"
        aria-disabled=${marking ? "true" : "false"}
        @click=${onCheck}
      >
        ${icons.check}${markWords.check}
      </button>
      <p role="status" aria-label=${markWords.status}>
        ${SIGNS[tone]}<span>${text.map((sentence) => html`<span>${sentence}</span> `)}</span>
      </p>
      ${
        marking
          ? html`<span class="count">
                ${progress ? markWords.count(progress) : nothing}
              </span>
              <button type="button" @click=${onCancel}>${markWords.cancel}</button>
              ${bar(progress)}`
          : nothing
      }
    </div>
    ${error === null || marking ? nothing : ours(error)}`;
}

const SIGNS = { quiet: nothing, busy: nothing, good: icons.passed, bad: icons.failed };

function bar(progress: MarkProgress | null): TemplateResult {
  return progress && progress.of > 0
    ? html`<progress aria-label=${markWords.progress} max=${progress.of} .value=${progress.done}>
      </progress>`
    : html`<progress aria-label=${markWords.progress}></progress>`;
}

/** A fault of ours is never told as the learner's. */
function ours(detail: string): TemplateResult {
  return html`<div class="task-ours">
    <p>${markWords.oursAgain}</p>
    <details>
      <summary>${markWords.oursDetail}</summary>
      <pre tabindex="0">${detail}</pre>
    </details>
  </div>`;
}

function say(input: MarkStatusInput): { tone: Tone; text: string[] } {
  const { phase, ready, waits, mark, stale, error, before } = input;
  if (phase === "marking") {
    return { tone: "busy", text: [ready ? (waits ?? markWords.marking) : markWords.waiting] };
  }
  if (error !== null) return { tone: "bad", text: [markWords.ours] };
  const cancelled = phase === "cancelled" ? [markWords.cancelled] : [];
  const outdated = stale ? [markWords.stale] : [];
  if (mark) {
    const tone = stale ? "quiet" : mark.passed ? "good" : "bad";
    return { tone, text: [...cancelled, ...outdated, ...result(mark)] };
  }
  if (cancelled.length > 0) return { tone: "quiet", text: cancelled };
  const best = before?.score ? [markWords.best(before.score)] : [];
  if (before?.state === "passed") {
    return { tone: "quiet", text: [markWords.passedBefore(new Date(before.at)), ...best] };
  }
  return { tone: "quiet", text: [before ? markWords.tried : markWords.none, ...best] };
}

function result({ passed, checks, score }: Mark): string[] {
  const scored = score ? [markWords.score(score)] : [];
  if (passed) return [markWords.passed(checks.length), ...scored];
  const first = checks.find(({ status }) => status === "failed");
  const fine = checks.filter(({ status }) => status === "passed").length;
  return [
    markWords.failed(fine, checks.length),
    ...(first && checks.length > 1 ? [markWords.failedFirst(first.title)] : []),
    ...scored,
  ];
}
