/**
 * A program of a task: a line with its verdict and, opened, its text beside what a learner reads,
 * drawn by the very parts that draw a learner's mark. May import `page`, `runtime` and `ui`.
 */
import { html, nothing, type TemplateResult } from "lit";
import { unsafeHTML } from "lit/directives/unsafe-html.js";
import { until } from "lit/directives/until.js";
import { emptyTrace } from "../page/empty-trace.ts";
import type { Shown } from "../page/marking.ts";
import "../page/results-card.ts";
import { checkList } from "../page/task-checks.ts";
import { markStatus } from "../page/task-status.ts";
import "../page/task.css";
import type { Mark, Where } from "../runtime/marks.ts";
import { runOf } from "../runtime/performed-run.ts";
import { readResults } from "../runtime/results.ts";
import { icons } from "../ui/icons.ts";
import { previewWords as words } from "../ui/preview-words.ts";
import { hintWords } from "../ui/task-words.ts";
import type { FailedRun, ProgramFile, TaskPreview, Told } from "./data.ts";
import { firstFailed, markOf, TONES, type Tone, type Verdict, verdictOf } from "./judged.ts";
import type { Context } from "./page-face.ts";

const SIGNS: Readonly<Record<Tone, TemplateResult>> = {
  good: icons.passed,
  bad: icons.failed,
  doubt: icons.tried,
  none: icons.notRun,
};

export function programRow(task: TaskPreview, file: ProgramFile, context: Context): TemplateResult {
  const { server, opened, redraw } = context;
  const part = `${task.name}/${file.file}`;
  const marking = server.work(task.name, "marks")?.waiting.has(file.file) ?? false;
  const failed = server.trouble(task.name, file.file);
  const verdict = marking ? "marking" : failed ? "trouble" : verdictOf(file);
  const onToggle = (event: Event): void => {
    opened.set(part, (event.target as HTMLDetailsElement).open);
    redraw();
  };
  return html`<details
    class="program"
    data-tone=${TONES[verdict]}
    ?open=${opened.open.has(part)}
    @toggle=${onToggle}
  >
    <summary>
      ${SIGNS[TONES[verdict]]}
      <code>${file.file}</code>
      <span class="note">${file.note}</span>
      <span class="verdict">${words.verdicts[verdict]}</span>
    </summary>
    ${opened.open.has(part) ? inside(task, file, verdict, failed, context) : nothing}
  </details>`;
}

function inside(
  task: TaskPreview,
  file: ProgramFile,
  verdict: Verdict,
  failed: string | null,
  { server }: Context,
): TemplateResult {
  const { told } = file;
  const again = verdict === "unmarked" ? words.markOne : words.again;
  return html`<div class="program-inside">
    <div class="program-text">
      <pre class="code" tabindex="0" role="region" aria-label=${words.program}><code
        >${unsafeHTML(file.html)}</code></pre>
      <p class="program-acts">
        <button
          type="button"
          aria-label=${words.markOf(file.file)}
          ?disabled=${server.work(task.name, "marks") !== null}
          @click=${() => void server.mark(task.name, [file.file])}
        >
          ${again}
        </button>
        <span>${told ? words.seconds(told.seconds) : nothing}</span>
        <span>${file.kind === "right" ? words.given : nothing}</span>
      </p>
    </div>
    <div class="told" role="region" aria-label=${words.reads}>
      <p class="told-title">${words.reads}</p>
      ${failed === null ? nothing : html`<pre class="failed" tabindex="0">${failed}</pre>`}
      ${told ? learnersMark(task, file, told, server) : html`<p class="none">${words.notYet}</p>`}
      ${told ? earned(file, told, verdict) : nothing}
    </div>
  </div>`;
}

// -- as a learner reads it -----------------------------------------------------------

function learnersMark(
  task: TaskPreview,
  file: ProgramFile,
  told: Told,
  server: Context["server"],
): TemplateResult {
  const mark = markOf(told);
  const hint = firstFailed(mark)?.hint ?? null;
  const run = told.hasRun ? server.run(file.key) : Promise.resolve(null);
  const list = (found: FailedRun | null): TemplateResult =>
    checkList({
      mark,
      shown: (where) => shownOf(where, found),
      hints: { opened: task.hints.length, of: task.hints.length },
      onShow: () => undefined,
      onNextHint: () => undefined,
      onHint: () => undefined,
    });
  const drawn = told.hasRun ? until(run.then(list), list(null)) : list(null);
  return html`<article class="task">
    <div class="task-panel">
      ${markStatus({
        phase: "marked",
        ready: true,
        progress: null,
        waits: null,
        mark,
        stale: false,
        error: mark.ours,
        before: null,
        onCheck: () => undefined,
        onCancel: () => undefined,
      })}
      ${mark.checks.length > 0 ? html`<div class="task-marks">${drawn} ${card(mark)}</div>` : nothing}
      ${hint === null ? nothing : pointedAt(task, hint)}
    </div>
  </article>`;
}

const shownRuns = new WeakMap<FailedRun, Shown>();

/** The run of the check that failed, or the bare world. */
function shownOf(where: Where, found: FailedRun | null): Shown {
  const bare = { trace: emptyTrace(where.world), isRun: false };
  if (!found || where.job === null) return bare;
  const known = shownRuns.get(found);
  if (known) return known;
  const { place, trace } = found;
  const limits = { real_s: 1, silent_s: 1 };
  const job = { id: where.job, limits, place: { ...place, number: place.seed }, text: "" };
  const run = runOf("", { job, result: JSON.stringify({ trace }) });
  const shown = run ? { trace: run, isRun: true } : bare;
  shownRuns.set(found, shown);
  return shown;
}

function card(mark: Mark): TemplateResult | typeof nothing {
  if (mark.results.length === 0) return nothing;
  const input = {
    results: readResults(mark.results),
    score: mark.score,
    before: null,
    earlier: [],
    checks: mark.checks.map(({ title }) => title),
    onShow: () => undefined,
    onRosMap: () => undefined,
  };
  return html`<results-card .input=${input}></results-card>`;
}

function pointedAt({ hints }: TaskPreview, hint: number): TemplateResult {
  return html`<section class="task-hints" aria-label=${words.pointsAt(hint + 1)}>
    <div class="task-hint">
      <p class="hint-title">${hintWords.title(hint + 1, hints.length)}</p>
      <div class="hint-text">${unsafeHTML(hints[hint] ?? "")}</div>
    </div>
  </section>`;
}

// -- for the author ------------------------------------------------------------------

/** What a wrong attempt should earn and what it does, where the two differ. */
function earned(file: ProgramFile, told: Told, verdict: Verdict): TemplateResult | typeof nothing {
  if (file.kind !== "wrong") return nothing;
  const failed = firstFailed(markOf(told));
  const got = failed?.likely ?? words.earnsNothing(failed?.got ?? "");
  return html`<dl class="earned" data-tone=${TONES[verdict]}>
    <div>
      <dt>${words.shouldEarn}</dt>
      <dd>${file.note}</dd>
    </div>
    ${
      verdict === "earns other words"
        ? html`<div>
            <dt>${words.earns}</dt>
            <dd>${got}</dd>
          </div>`
        : nothing
    }
  </dl>`;
}
