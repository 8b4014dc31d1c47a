/**
 * One program with many seeds, one run after the other: how much of a result is luck.
 * Dispatches "change" as runs end. May import `runtime`, `trace`, `views/chart-data` and `ui`.
 */
import type { Running, RunRequest, Runtime } from "../runtime/client.ts";
import type { Trace } from "../trace/trace.ts";
import { repeatWords } from "../ui/noise-words.ts";
import { short } from "../views/chart-data.ts";
import { MOST_SEED } from "./address.ts";

export const TIMES = 20;

/** The next run's interpreter starts while this one runs. */
const SPARES = 2;

export interface RepeatListeners {
  /** The first run has ended well: the one to look at while the others follow. */
  onFirst(trace: Trace): void;
  /** A run has ended in another way than by finishing, and the series with it. */
  onFailed(trace: Trace): void;
}

export class Repeat extends EventTarget {
  readonly #runtime: Pick<Runtime, "run" | "expect">;
  readonly #listeners: RepeatListeners;
  #runs: Trace[] = [];
  #failed: Trace | null = null;
  #running: Running | null = null;

  constructor(runtime: Pick<Runtime, "run" | "expect">, listeners: RepeatListeners) {
    super();
    this.#runtime = runtime;
    this.#listeners = listeners;
  }

  /** The runs that have finished. A new list each time there is one more. */
  get runs(): readonly Trace[] {
    return this.#runs;
  }

  /** How far the series is, or null if none is under way. */
  get progress(): { done: number; of: number } | null {
    return this.#running && { done: this.#runs.length, of: TIMES };
  }

  /** A line a run, and after the last what they come to. */
  get report(): string {
    const lines = this.#runs.map(lineOf);
    if (this.#failed) lines.push(lineOf(this.#failed));
    if (!this.#running) lines.push(...summaryOf(this.#runs));
    return lines.join("\n");
  }

  /** Runs the program with the request's seed, the next one, and so on, to the end of the series. */
  async start(request: RunRequest): Promise<void> {
    this.clear();
    this.#runtime.expect(SPARES);
    for (let i = 0; i < TIMES; i++) {
      const seed = (request.seed + i) % (MOST_SEED + 1);
      const mine = this.#runtime.run({ ...request, seed });
      this.#running = mine;
      if (i === 0) this.#changed();
      const trace = await mine.done;
      // Cancelled, or another series has begun.
      if (this.#running !== mine) return;
      if (trace.end?.status !== "finished") {
        this.#failed = trace;
        this.#listeners.onFailed(trace);
        break;
      }
      this.#runs = [...this.#runs, trace];
      if (i === 0) this.#listeners.onFirst(trace);
      this.#changed();
      if (this.#running !== mine) return;
    }
    this.cancel();
  }

  /** Ends the series; the runs that have finished stay. */
  cancel(): void {
    const running = this.#running;
    if (!running) return;
    this.#running = null;
    running.stop();
    this.#runtime.expect(1);
    this.#changed();
  }

  /** Ends the series and forgets its runs. */
  clear(): void {
    this.cancel();
    if (this.#runs.length === 0 && !this.#failed) return;
    this.#runs = [];
    this.#failed = null;
    this.#changed();
  }

  #changed(): void {
    this.dispatchEvent(new Event("change"));
  }
}

function lineOf(trace: Trace): string {
  const { seed } = trace.header;
  const { end } = trace;
  if (end?.status === "fault") return repeatWords.failed(seed);
  if (end?.status === "limit") return repeatWords.limit(seed, end.message);
  const values = Array.from(endValues(trace), ([name, value]) => `${name} ${short(value)}`);
  return repeatWords.run(seed, values.join(", "));
}

/** The last value of each chart line. */
function endValues(trace: Trace): Map<string, number> {
  return new Map(
    Array.from(trace.series, ([name, { value }]) => [name, value.at(value.length - 1)]),
  );
}

/** Median, lowest and highest end value of each chart line, over the runs that have it. */
function summaryOf(runs: readonly Trace[]): string[] {
  if (runs.length === 0) return [];
  const ends = runs.map(endValues);
  const names = new Set(ends.flatMap((values) => [...values.keys()]));
  const lines = Array.from(names, (name) => {
    const values = ends.flatMap((end) => end.get(name) ?? []).sort((a, b) => a - b);
    const [low, high] = [values[0], values.at(-1)].map((value) => short(value ?? Number.NaN));
    return repeatWords.line(name, short(medianOf(values)), low ?? "", high ?? "");
  });
  return [repeatWords.summary(runs.length), ...lines];
}

function medianOf(rising: readonly number[]): number {
  const middle = (rising.length - 1) / 2;
  const pair = [rising[Math.floor(middle)], rising[Math.ceil(middle)]];
  return ((pair[0] ?? Number.NaN) + (pair[1] ?? Number.NaN)) / 2;
}
