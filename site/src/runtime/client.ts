/**
 * Python for a page: one Runtime, however many labs. May import `trace` only.
 */
import type { World } from "../trace/events.ts";
import type { Trace } from "../trace/trace.ts";
import { Assets } from "./assets.ts";
import { type Converted, convert } from "./converter.ts";
import { type Device, inWords, isSmall, obstacle } from "./device.ts";
import { type Marked, Marker, type MarkListeners } from "./marker.ts";
import type { JudgeRequest, RunRequest } from "./messages.ts";
import { Pool, type Workers } from "./pool.ts";
import { Run, type RunListeners } from "./run.ts";
import { NotLoaded } from "./scripts.ts";

export type { Converted } from "./converter.ts";
export type { Marked, MarkListeners, MarkProgress } from "./marker.ts";
export type { JudgeRequest, RunRequest } from "./messages.ts";
export type { RunListeners } from "./run.ts";

/** cold: nothing asked for yet. loading: on its way. ready: a run starts at once. */
export type RuntimeState = "cold" | "loading" | "ready" | "failed";

/** A run under way. `trace` grows; `done` resolves for every ending, which `trace.end` tells. */
export interface Running {
  readonly trace: Trace;
  readonly done: Promise<Trace>;
  stop(): void;
}

/** A marking under way. `done` resolves for every ending. */
export interface Marking {
  readonly done: Promise<Marked>;
  cancel(): void;
}

/** A real program that is run out of sight, so that the engine has compiled the hot paths. */
export interface WarmUp {
  program: string;
  world: World;
}

/** A page that has just started has enough to do, and a reader may be about to press Run. */
const SETTLE_MS = 1500;

/** Dispatches "change" when `state` or `progress` has changed. */
export class Runtime extends EventTarget {
  #state: RuntimeState = "cold";
  #error: string | null = null;
  #assets: Assets | null = null;
  #pool: Pool | null = null;
  /** Settles when the first interpreter is ready, or none can be had. */
  #started: Promise<void> = Promise.resolve();
  readonly #warmUp: WarmUp | null;
  /** The device bears one interpreter at a time. */
  readonly isSmall: boolean;
  #warmingUp: Run | null = null;
  /** The reader's last run or marking; null before the first. */
  #work: Promise<unknown> | null = null;
  /** No interpreter is to wait for work: nobody sees the lab. */
  #rests = false;

  constructor(warmUp: WarmUp | null = null, device: Device = navigator) {
    super();
    this.isSmall = isSmall(device);
    // A run out of sight takes an interpreter of its own.
    this.#warmUp = this.isSmall ? null : warmUp;
  }

  get state(): RuntimeState {
    return this.#state;
  }

  /** What went wrong, when the state is failed. */
  get error(): string | null {
    return this.#error;
  }

  /** Bytes of the download, as transferred. */
  get progress(): { loaded: number; total: number; label: string } {
    const { loaded = 0, total = 0 } = this.#assets?.progress ?? {};
    const label = loaded < total ? "Loading Python" : "Starting Python";
    return { loaded, total, label };
  }

  /** Start downloading and starting Python. Does nothing when that is under way or done. */
  warm(): void {
    if (this.#state === "loading" || this.#state === "ready") return;
    this.#started = this.#start();
    // Whoever waits for it hears of a failure, and the state tells it to everybody.
    this.#started.catch(() => {});
  }

  /** Run a program. Starts Python if need be; the run then waits for it. */
  run(request: RunRequest, listeners: RunListeners = {}): Running {
    const { workers, assets } = this.#staff();
    return this.#begun(new Run(request, listeners, workers, assets));
  }

  /** Mark a program by a check. Starts Python if need be; the marking then waits for it. */
  mark(request: JudgeRequest, listeners: MarkListeners = {}): Marking {
    const { workers, assets } = this.#staff();
    return this.#begun(new Marker(request, listeners, workers, assets));
  }

  /**
   * Ask the site's own Python: JSON and files' bytes in, JSON and bytes out. Starts Python if need
   * be, and waits for it.
   */
  async convert(request: string, files: readonly ArrayBuffer[] = []): Promise<Converted> {
    const { workers, assets } = this.#staff();
    return convert(request, files, workers, assets);
  }

  #begun<Work extends { done: Promise<unknown> }>(work: Work): Work {
    this.#work = work.done;
    this.#warmingUp?.stop();
    return work;
  }

  /** Whoever does the work, as soon as Python has started. */
  #staff(): { workers: Workers; assets: Assets } {
    this.warm();
    const started = this.#started;
    const pool = this.#pool;
    if (!pool || !this.#assets) throw new Error("warm() leaves a pool behind");
    const take = async () => {
      await started;
      return pool.take();
    };
    const prepare = async () => {
      if (!this.#rests) await pool.prepare();
    };
    const workers = { take, prepare, oneAtATime: this.isSmall };
    return { workers, assets: this.#assets };
  }

  /**
   * Resolves when so many runs would start at once, of as many as are expected; rejects if Python
   * can't be started.
   */
  async ready(runs = 1): Promise<void> {
    this.warm();
    await this.#started;
    await this.#pool?.prepare(this.isSmall ? 1 : runs);
  }

  /** Many short runs are coming: have so many interpreters to spare. 1 gives the others back. */
  expect(spares: number): void {
    this.#pool?.hold(this.isSmall ? 0 : spares);
    // A failure shows when an interpreter is needed.
    if (this.#state === "ready" && !this.#rests) this.#pool?.prepare().catch(() => {});
  }

  /** While nobody sees the lab no interpreter waits for work; what is under way goes on. */
  async rest(rests: boolean): Promise<void> {
    this.#rests = rests;
    await this.#work;
    if (this.#rests !== rests) return;
    if (rests) this.#pool?.hold(0);
    else if (!this.isSmall) this.expect(1);
  }

  async #start(): Promise<void> {
    const assets = new Assets(obstacle(globalThis));
    const pool = new Pool(() => assets.boot());
    // None but the one that is asked for.
    if (this.isSmall) pool.hold(0);
    this.#assets = assets;
    this.#pool = pool;
    assets.progress.addEventListener("change", () => this.#changed());
    this.#become("loading");
    try {
      await pool.prepare().catch(async (error: unknown) => {
        const isSnapshots = !(error instanceof NotLoaded);
        if (!isSnapshots || !(await assets.dropSnapshot(error))) throw error;
        await pool.prepare();
      });
    } catch (error) {
      this.#become("failed", inWords(error));
      throw error;
    }
    this.#become("ready");
    void this.#followUp(pool, assets);
  }

  /** What can wait until Python is up, and gives way to what the reader runs. */
  async #followUp(pool: Pool, assets: Assets): Promise<void> {
    await this.#runWarmUp(pool, assets);
    await this.#work;
    // A program that needs it before fetches it itself, and hears of a failure.
    assets.stdlib().catch(() => {});
  }

  /**
   * In a worker of its own, which is then thrown away: what the engine has compiled serves the next
   * ones. The reader's own runs do as well, and have the machine to themselves.
   */
  async #runWarmUp(pool: Pool, assets: Assets): Promise<void> {
    await new Promise((resolve) => setTimeout(resolve, SETTLE_MS));
    if (!this.#warmUp || this.#work) return;
    const workers: Workers = {
      take: () => pool.start(),
      prepare: async () => {},
      oneAtATime: false,
    };
    this.#warmingUp = new Run({ ...this.#warmUp, seed: 0 }, {}, workers, assets);
    await this.#warmingUp.done;
    this.#warmingUp = null;
  }

  #become(state: RuntimeState, error: string | null = null): void {
    this.#state = state;
    this.#error = error;
    this.#changed();
  }

  #changed(): void {
    this.dispatchEvent(new Event("change"));
  }
}
