/**
 * What a task knows of its marks' runs: keeps the score, remembers the attempt before, and fetches
 * the card that shows them when the first mark reports any. May import `runtime`.
 */
import type { Mark, Where } from "../runtime/marks.ts";
import type { Result } from "../runtime/results.ts";
import { part } from "../ui/part.ts";
import type { Progress, ScoreRecord } from "./progress.ts";
import type { CardInput } from "./results-card.ts";

export class TaskResults {
  readonly #progress: Progress;
  readonly #lesson: string;
  readonly #task: string;
  #mark: Mark | null = null;
  #results: readonly Result[] = [];
  #earlier: readonly Result[] = [];
  #before: ScoreRecord | null = null;
  readonly #places = new WeakMap<Result, Where>();
  #wrongCells: (map: Result["map"]) => Where["cells"] = () => [];

  constructor(progress: Progress, lesson: string, task: string) {
    this.#progress = progress;
    this.#lesson = lesson;
    this.#task = task;
  }

  /** Takes in a new mark; resolves when what it reports can be shown. */
  async take(mark: Mark): Promise<void> {
    const { score, results } = mark;
    if (score) {
      this.#before = this.#progress.of(this.#lesson, this.#task)?.score ?? null;
      this.#progress.scored(this.#lesson, this.#task, score.value, score.of);
    }
    if (results.length > 0) {
      const [{ readResults }, { wrongCells }] = await Promise.all([
        part(() => import("../runtime/results.ts")),
        part(() => import("./result-map.ts")),
        part(() => import("./results-card.ts")),
      ]);
      this.#wrongCells = wrongCells;
      this.#earlier = this.#results;
      this.#results = readResults(results);
    }
    this.#mark = mark;
  }

  /** What the card of a mark shows; null if it reports no runs. */
  card(mark: Mark, act: Pick<CardInput, "onRosMap"> & { onShow(where: Where): void }) {
    if (this.#mark !== mark || mark.results.length === 0) return null;
    const input: CardInput = {
      results: this.#results,
      score: mark.score,
      before: this.#before,
      earlier: this.#earlier,
      checks: mark.checks.map(({ title }) => title),
      onShow: (result) => act.onShow(this.#placeOf(result)),
      onRosMap: act.onRosMap,
    };
    return input;
  }

  /** The end of a run, its wrong cells outlined. */
  #placeOf(result: Result): Where {
    const known = this.#places.get(result);
    if (known) return known;
    const { world, job, map } = result;
    const cells = this.#wrongCells(map);
    const place = { world, cells, cell_cm: map?.cell_cm ?? 5, seconds: null, job };
    this.#places.set(result, place);
    return place;
  }
}
