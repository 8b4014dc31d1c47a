/**
 * Redoes the run while a number moves: one run at a time, and after it the newest value.
 * Imports a type of `editor`; what a run is is handed in.
 */
import type { NumberEvent } from "../editor/gesture.ts";

/** Interpreters to have ready while numbers move: each run uses one up. */
const SPARES = 3;
/** They are given back so long after the last run [ms]: the next movement most often comes soon. */
const KEEP_MS = 5000;
/** An overtaken run that has taken this long is not waited for: it may never end [ms]. */
const LONG_MS = 1000;

export interface RedoingOptions {
  /** A number begins to move, with the run from before on show. */
  begin(): void;
  /** Resolves when so many runs would start at once. */
  ready(runs: number): Promise<void>;
  /** Runs the program as it is now, ending the run before; resolves when it has ended. */
  run(): Promise<unknown>;
  /** Have so many interpreters to spare. */
  expect(spares: number): void;
}

export class Redoing {
  readonly #options: RedoingOptions;
  #moving = false;
  /** No run of this movement has begun. */
  #first = true;
  /** Ends the wait of a run that is to leave an interpreter for the last value. */
  #letGo: () => void = () => {};
  /** The run under way, or none. A new object for each: an overtaken one knows it by that. */
  #underWay: { since: number | null } | null = null;
  /** The program has changed since the run under way began. */
  #again = false;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(options: RedoingOptions) {
    this.#options = options;
  }

  on(event: NumberEvent): void {
    if (event === "held") {
      this.#options.expect(SPARES);
    } else if (event === "moved") {
      if (!this.#moving) this.#begin();
      this.#again = true;
    } else {
      this.#moving = false;
      this.#letGo();
    }
    this.#next();
  }

  #begin(): void {
    this.#moving = true;
    this.#first = true;
    this.#options.begin();
  }

  /** Starts what is to be started now, and sees to it that something does later. */
  #next(): void {
    clearTimeout(this.#timer);
    if (!this.#again) {
      if (!this.#underWay) this.#timer = setTimeout(() => this.#options.expect(1), KEEP_MS);
      return;
    }
    if (!this.#underWay) {
      void this.#run();
      return;
    }
    const { since } = this.#underWay;
    if (since === null) return;
    // Let go, only the last value counts. Before that even a late state is better than none,
    // unless it takes too long.
    const left = this.#moving ? since + LONG_MS - performance.now() : 0;
    if (left > 0) this.#timer = setTimeout(() => this.#next(), left);
    else void this.#run();
  }

  async #run(): Promise<void> {
    const mine: { since: number | null } = { since: null };
    this.#underWay = mine;
    await this.#interpreter();
    // The program is read as late as can be: when there is an interpreter to run it.
    this.#again = false;
    mine.since = performance.now();
    await this.#options.run();
    if (this.#underWay !== mine) return;
    this.#underWay = null;
    this.#next();
  }

  /**
   * Waits for an interpreter. While the number moves on there is to be one more, so that the last
   * value need not wait for its own; only the first run takes what there is.
   */
  async #interpreter(): Promise<void> {
    const keepsOne = this.#moving && !this.#first;
    this.#first = false;
    const released = new Promise<void>((resolve) => {
      this.#letGo = resolve;
    });
    // That Python can't be started is told by the run.
    const ready = (runs: number): Promise<void> => this.#options.ready(runs).catch(() => {});
    if (keepsOne) await Promise.race([ready(2), released]);
    await ready(1);
  }
}
