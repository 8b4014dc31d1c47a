/**
 * The line under a lab's title: what is going on, how far it has got, and what can be done.
 *
 * It is always there, so nothing moves when Python arrives or a run ends. What is read out by a
 * screen reader (role status) changes only when something has happened, never while a number counts.
 * May import `trace` and `ui`.
 */
import { html, nothing, type TemplateResult } from "lit";
import type { End, Fault } from "../trace/events.ts";
import { repeatWords } from "../ui/noise-words.ts";
import { labWords, statusWords } from "../ui/strings.ts";
import "./status.css";

/** Where the lab's own program is. Python's start-up is `runtime`'s business. */
export type Phase = "idle" | "waiting" | "running" | "ended";

export interface StatusInput {
  phase: Phase;
  runtime: {
    state: "cold" | "loading" | "ready" | "failed";
    progress: { loaded: number; total: number; label: string };
    error: string | null;
  };
  /** How far the running program has got in simulated time [s]. */
  reached: number;
  end: End | null;
  fault: Fault | null;
  /** What there is to say besides, with what can be done about it. */
  notes: readonly Note[];
  /** What the runtime says of a run that is held up ("Loading NumPy… 40 %"). */
  runNote: string | null;
  /** How far a series of runs is, or null. */
  series: { done: number; of: number } | null;
  onRetry(): void;
  /** Ends the series. */
  onCancel(): void;
  /** The learner wants to see the line that failed. */
  onLine(line: number): void;
}

export interface Note {
  text: string;
  action?: Action;
}

export interface Action {
  label: string;
  act(): void;
}

type Tone = "quiet" | "busy" | "good" | "bad";

export function status(input: StatusInput): TemplateResult {
  const { tone, text } = say(input);
  return html`<div class="lab-status" data-tone=${tone}>
    <p role="status" aria-label=${statusWords.label}>
      <span class="dot" aria-hidden="true"></span><span>${text}</span>
      ${input.notes.map(({ text }) => html`<span class="note">${text}</span>`)}
    </p>
    ${actions(input).map(
      ({ label, act }) => html`<button type="button" @click=${act}>${label}</button>`,
    )}
    <span class="count">${count(input)}</span>
    ${bar(input)}
  </div>`;
}

function bar({ runtime, series }: StatusInput): TemplateResult | typeof nothing {
  const { loaded, total } = runtime.progress;
  const shown =
    runtime.state === "loading"
      ? { label: statusWords.starting, value: loaded, max: total || 1 }
      : series && { label: repeatWords.goingOn, value: series.done, max: series.of };
  if (!shown) return nothing;
  const { label, value, max } = shown;
  return html`<progress aria-label=${label} max=${max} .value=${value}></progress>`;
}

function actions(input: StatusInput): Action[] {
  const { runtime, fault, notes, series, onRetry, onLine, onCancel } = input;
  const list: Action[] = [];
  if (series) list.push({ label: repeatWords.cancel, act: onCancel });
  const line = fault?.line;
  if (line) list.push({ label: statusWords.goTo(line), act: () => onLine(line) });
  for (const { action } of notes) if (action) list.push(action);
  if (runtime.state === "failed") list.push({ label: labWords.retry, act: onRetry });
  return list;
}

function say(input: StatusInput): { tone: Tone; text: string } {
  const { phase, runtime, end, fault, runNote, series } = input;
  if (runtime.state === "failed") {
    return { tone: "bad", text: statusWords.failed(runtime.error ?? "") };
  }
  if (series) return { tone: "busy", text: repeatWords.goingOn };
  if (phase === "waiting") return { tone: "busy", text: statusWords.waiting };
  if (phase === "running") return { tone: "busy", text: runNote ?? statusWords.running };
  if (end) return { tone: TONES[end.status], text: endWords(end, fault) };
  if (runtime.state === "loading") return { tone: "busy", text: statusWords.starting };
  const text = runtime.state === "ready" ? statusWords.ready : statusWords.cold;
  return { tone: "quiet", text };
}

const TONES: Record<End["status"], Tone> = {
  finished: "good",
  fault: "bad",
  stopped: "quiet",
  limit: "bad",
};

/** How a run has ended. */
export function endWords({ status, t, message }: End, fault: Fault | null): string {
  switch (status) {
    case "finished":
      return statusWords.finished(t);
    case "fault":
      return statusWords.fault(fault?.line ?? null);
    case "stopped":
      return statusWords.stopped(t);
    case "limit":
      return message;
  }
}

function count({ phase, runtime, reached, series }: StatusInput): string {
  if (series) return repeatWords.count(series.done, series.of);
  if (phase === "running") return statusWords.reached(reached);
  const { loaded, total } = runtime.progress;
  return runtime.state === "loading" && total > 0 ? statusWords.bytes(loaded, total) : "";
}
