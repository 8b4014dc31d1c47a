/**
 * The runs of one lab, one at a time: starts and stops them, and knows how the last one stands.
 * Dispatches "change" when any of that changes. May import `runtime` and `trace`.
 */
import type { Running, RunRequest, Runtime } from "../runtime/client.ts";
import type { Trace } from "../trace/trace.ts";
import type { Phase } from "./status.ts";

export interface RunnerListeners {
  /** A run has begun, or is another one than before: this is its trace; `end`: show its end. */
  onTrace(trace: Trace, end: boolean): void;
  /** The trace on show has grown. */
  onGrown(): void;
  /** The run has ended, however it did. */
  onEnd(trace: Trace): void;
}

/** A run that shows only its end is not spoken of unless it takes longer than this [ms]. */
const QUIET_MS = 300;

export class Runner extends EventTarget {
  readonly #runtime: Runtime;
  readonly #listeners: RunnerListeners;
  #phase: Phase = "idle";
  #running: Running | null = null;
  #trace: Trace | null = null;
  #note: string | null = null;

  constructor(runtime: Runtime, listeners: RunnerListeners) {
    super();
    this.#runtime = runtime;
    this.#listeners = listeners;
  }

  get phase(): Phase {
    return this.#phase;
  }

  /** The run under way or the last one; null before the first. */
  get trace(): Trace | null {
    return this.#trace;
  }

  /** What holds the run up, in words, or null. */
  get note(): string | null {
    return this.#note;
  }

  /**
   * Runs a program to its end. One that is still running is stopped first. With `atEnd` the run
   * before stays on show until this one has ended.
   */
  async run(request: RunRequest, atEnd = false): Promise<Trace> {
    this.stop();
    const mine = this.#runtime.run(request, {
      onChunk: (trace) => {
        if (this.#running === mine && !atEnd) this.#grown(trace);
      },
      onNote: (text) => {
        if (this.#running !== mine) return;
        this.#note = text;
        this.#changed();
      },
    });
    this.#running = mine;
    this.#note = null;
    const begin = (): void => {
      if (this.#running !== mine) return;
      this.#phase = this.#runtime.state === "ready" ? "running" : "waiting";
      this.#changed();
    };
    if (!atEnd) this.#show(mine.trace);
    if (atEnd && this.#trace && this.#runtime.state === "ready") setTimeout(begin, QUIET_MS);
    else begin();
    const trace = await mine.done;
    if (this.#running === mine) {
      this.#running = null;
      this.#phase = "ended";
      this.#note = null;
      if (this.#trace !== trace) this.#show(trace, atEnd);
      this.#listeners.onEnd(trace);
      this.#changed();
    }
    return trace;
  }

  /** Shows a run made before, in place of the last one. */
  open(trace: Trace): void {
    this.clear();
    this.#phase = "ended";
    this.#show(trace);
    this.#listeners.onEnd(trace);
    this.#changed();
  }

  stop(): void {
    this.#running?.stop();
  }

  /** Forgets the last run: another world is on show. */
  clear(): void {
    this.stop();
    this.#running = null;
    this.#trace = null;
    this.#phase = "idle";
    this.#note = null;
    this.#changed();
  }

  /** Python's state has changed: what was waiting for it may be running now. */
  runtimeChanged(): void {
    if (this.#phase === "waiting" && this.#runtime.state === "ready") this.#phase = "running";
    this.#changed();
  }

  #grown(trace: Trace): void {
    this.#phase = "running";
    if (trace !== this.#trace) this.#show(trace);
    else this.#listeners.onGrown();
    this.#changed();
  }

  #show(trace: Trace, end = false): void {
    this.#trace = trace;
    this.#listeners.onTrace(trace, end);
  }

  #changed(): void {
    this.dispatchEvent(new Event("change"));
  }
}
