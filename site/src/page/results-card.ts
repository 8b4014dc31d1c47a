/**
 * <results-card>: all the runs of a project's mark. The score with the best one and the last; for
 * each mat what is really there beside the map of every run, why each stopped, and the figures
 * against their limits.
 *
 * Set `input`. Fetched with the first mark that reports runs. May import `runtime`, `trace` and `ui`.
 */
import { html, LitElement, nothing, type TemplateResult } from "lit";
import type { Score } from "../runtime/marks.ts";
import type { Result } from "../runtime/results.ts";
import { icons } from "../ui/icons.ts";
import { number, resultsWords as words } from "../ui/results-words.ts";
import type { ScoreRecord } from "./progress-record.ts";
import { mapPicture, truthPicture } from "./result-map.ts";
import { figureTable } from "./results-table.ts";
import "./results-card.css";

export interface CardInput {
  results: readonly Result[];
  score: Score | null;
  /** The scores as they were before this mark; null if there were none. */
  before: ScoreRecord | null;
  /** The results of the attempt before, on this page; none after a reload. */
  earlier: readonly Result[];
  /** Titles of the mark's checks, which tell a mat's character. */
  checks: readonly string[];
  onShow(result: Result): void;
  onRosMap(result: Result): void;
}

class ResultsCard extends LitElement {
  static override properties = { input: { attribute: false } };
  declare input: CardInput | undefined;

  /** In the page itself, not in a shadow: one style sheet. */
  override createRenderRoot(): HTMLElement {
    return this;
  }

  override render(): TemplateResult {
    if (!this.input) return html``;
    const { input } = this;
    return html`<section class="results" aria-label=${words.title}>
      ${scoreOf(input)} ${legend()} ${matsOf(input.results).map((runs) => mat(runs, input))}
    </section>`;
  }
}

/** The runs of one check on one world belong together. */
function matsOf(results: readonly Result[]): Result[][] {
  const mats = new Map<string, Result[]>();
  for (const result of results) {
    const key = `${result.check} ${result.world.name}`;
    mats.set(key, [...(mats.get(key) ?? []), result]);
  }
  return [...mats.values()];
}

// -- the score -------------------------------------------------------------------------

function scoreOf({ score, before, results }: CardInput): TemplateResult {
  const kept = results.filter(({ passed }) => passed).length;
  const limits = html`<p>${words.kept(kept, results.length)}</p>`;
  if (!score) return html`<header class="results-head">${limits}</header>`;
  return html`<header class="results-head">
      <p class="score">
        <span>${words.score}</span>
        <strong>${number(score.value, 1)}</strong>
        <span>${words.of(score.of)}</span>
      </p>
      <div class="score-words">
        <p>${compared(score, before)}</p>
        ${limits}
      </div>
    </header>
    <p class="score-how"><b>${words.how}</b>: ${score.how}</p>`;
}

function compared({ value, of }: Score, before: ScoreRecord | null): string {
  if (!before || before.of !== of) return words.first;
  const by = value - before.last;
  const last = by === 0 ? words.unchanged : by > 0 ? words.more(by) : words.less(-by);
  if (value > before.best) return `${words.best(before.best)} ${last}`;
  if (value === before.best) return `${words.same} ${last}`;
  return `${words.notBest(before.best, before.bestAt)} ${last}`;
}

// -- the mats ----------------------------------------------------------------------------

function legend(): TemplateResult {
  const kinds = ["free", "occupied", "unknown", "wrong"] as const;
  return html`<p class="results-legend">
    ${words.legend}:
    ${kinds.map((kind) => html`<span><i class=${kind}></i>${words[kind]}</span> `)}
  </p>`;
}

function mat(runs: readonly Result[], input: CardInput): TemplateResult {
  const [first] = runs;
  if (!first) return html``;
  const { world, check } = first;
  const earlier = ({ seed }: Result): Result | undefined =>
    input.earlier.find((run) => run.world.name === world.name && run.seed === seed);
  return html`<section class="results-mat" aria-label=${words.mat(world.title)}>
    <p class="mat-title"><b>${world.title}</b> <span>${input.checks[check] ?? ""}</span></p>
    <div class="result-maps">
      <figure>
        ${truthPicture(world)}
        <figcaption><b>${words.truth}</b></figcaption>
      </figure>
      ${runs.map((run) => runFigure(run, input))}
    </div>
    ${figureTable(runs, earlier)}
  </section>`;
}

function runFigure(run: Result, { onShow, onRosMap }: CardInput): TemplateResult {
  const { world, seed, passed, why, map } = run;
  return html`<figure data-status=${passed ? "passed" : "failed"}>
    ${mapPicture(run)}
    <figcaption>
      <b>${words.seed(seed)}</b>
      <span class="run-state">
        ${passed ? icons.passed : icons.failed}
        <span class="out-of-sight">${passed ? words.keeps : words.breaks}.</span>
      </span>
      <span class="run-why">${why}</span>
    </figcaption>
    <div class="run-acts">
      <button
        type="button"
        aria-label=${words.showOf(world.title, seed)}
        @click=${() => onShow(run)}
      >
        ${words.show}
      </button>
      ${
        map
          ? html`<button
              type="button"
              aria-label=${words.rosMapOf(world.title, seed)}
              @click=${() => onRosMap(run)}
            >
              ${words.rosMap}
            </button>`
          : nothing
      }
    </div>
  </figure>`;
}

customElements.define("results-card", ResultsCard);
