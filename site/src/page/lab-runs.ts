/**
 * The runs of one lab, and which of them is on show: a run, one redone while a number moves, one of
 * a series with many seeds, one from a file, or a guest: a run the page shows here that is not the
 * lab's own (on a hidden world, say). Knows no element.
 *
 * Dispatches "change" when anything but the shown time has changed. May import `runtime`, `player`,
 * `trace` and, of the editor, a type.
 */
import type { NumberEvent } from "../editor/gesture.ts";
import { Player } from "../player/player.ts";
import type { RunRequest, Runtime } from "../runtime/client.ts";
import type { Cell } from "../trace/frames.ts";
import type { Trace } from "../trace/trace.ts";
import { Redoing } from "./redoing.ts";
import { Repeat } from "./repeat.ts";
import { Runner } from "./runner.ts";

export interface LabRunsOptions {
  runtime: Runtime;
  /** The world before any run. */
  empty: Trace;
  /** What is to be run; asked as late as can be. */
  request(): RunRequest;
  /** Another run is on show. */
  onShow(trace: Trace): void;
  /** The run on show is to be played, at the speed the reader has chosen. */
  onPlay(): void;
  /** The run on show ended with an error on this line (1 first). */
  onFault(line: number, message: string): void;
  /** The series ended early, with this run on show. */
  onFailed(trace: Trace): void;
}

/** What to say of a run that is not the lab's own, and what to show of it. */
export interface GuestOptions {
  /** Which run this is, in a sentence. */
  note: string;
  /** Cells to point out on the overhead view. */
  outlined?: readonly Cell[];
  /** The moment to show [s]; the end if there is none. */
  seconds?: number | null;
}

interface Guest {
  options: GuestOptions;
  /** What was on show before it. */
  own: { trace: Trace | null; earlier: Trace | null; time: number };
}

export class LabRuns extends EventTarget {
  readonly player: Player;
  readonly #options: LabRunsOptions;
  readonly #runner: Runner;
  readonly #redoing: Redoing;
  readonly #repeat: Repeat;
  #empty: Trace;
  #earlier: Trace | null = null;
  #guest: Guest | null = null;

  constructor(options: LabRunsOptions) {
    super();
    const { runtime } = options;
    this.#options = options;
    this.#empty = options.empty;
    this.player = new Player(options.empty, (callback) => requestAnimationFrame(callback));
    this.#runner = new Runner(runtime, {
      onTrace: (trace, end) => this.#show(trace, end),
      onGrown: () => this.player.grown(),
      onEnd: (trace) => this.#ended(trace),
    });
    this.#redoing = new Redoing({
      begin: () => this.#leaveRun(),
      ready: (runs) => runtime.ready(runs),
      run: () => this.#runner.run(options.request(), true),
      expect: (spares) => runtime.expect(spares),
    });
    this.#repeat = new Repeat(runtime, {
      onFirst: (trace) => this.#showEnd(trace),
      onFailed: (trace) => {
        this.#showEnd(trace);
        options.onFailed(trace);
      },
    });
    const changed = (): boolean => this.dispatchEvent(new Event("change"));
    this.#runner.addEventListener("change", changed);
    this.#repeat.addEventListener("change", changed);
  }

  // -- how things stand --------------------------------------------------------------

  /** The run on show; null before the first. */
  get trace(): Trace | null {
    return this.#runner.trace;
  }

  /** The run before the one on show, to compare it with. */
  get earlier(): Trace | null {
    return this.#earlier;
  }

  /** Where the run stands, and what holds it up, in words, or null. */
  get state(): Pick<Runner, "phase" | "note"> {
    return this.#runner;
  }

  /** The runs of the series that have finished, what they come to, and how far it is. */
  get series(): Pick<Repeat, "runs" | "report" | "progress"> {
    return this.#repeat;
  }

  /** What is shown of a run that is not the lab's own; null while it is. */
  get guest(): GuestOptions | null {
    return this.#guest?.options ?? null;
  }

  // -- running -----------------------------------------------------------------------

  /** Runs the program, showing it as it comes, and resolves when it has ended, however it does. */
  run(): Promise<Trace> {
    this.#leaveRun();
    return this.#runner.run(this.#options.request());
  }

  /** Redoes the run while a number moves, showing only the end. */
  follow(event: NumberEvent): void {
    this.#redoing.on(event);
  }

  /** Runs the program with many seeds. */
  repeat(): void {
    this.#runner.stop();
    void this.#repeat.start(this.#options.request());
  }

  /** Ends the series; the runs that have finished stay. */
  cancelSeries(): void {
    this.#repeat.cancel();
  }

  /** Ends what is running; what it has shown is kept. */
  stop(): void {
    this.#repeat.cancel();
    this.#runner.stop();
  }

  /** Python's state has changed. */
  runtimeChanged(): void {
    this.#runner.runtimeChanged();
  }

  // -- showing -----------------------------------------------------------------------

  /** Shows a run made before, with nothing to compare it with. */
  open(trace: Trace): void {
    this.#guest = null;
    this.#repeat.clear();
    this.#earlier = null;
    this.#runner.open(trace);
  }

  /** Shows a run that is not the lab's own, until the next one or `backToOwn`. */
  openGuest(trace: Trace, options: GuestOptions): void {
    const own = this.#guest?.own ?? {
      trace: this.trace,
      earlier: this.#earlier,
      time: this.player.time,
    };
    this.#repeat.clear();
    this.#guest = { options, own };
    this.#earlier = null;
    this.#runner.open(trace);
    this.player.toEnd();
    if (typeof options.seconds === "number") this.player.seek(options.seconds);
  }

  /** Shows again what was on show before the guest; does nothing without one. */
  backToOwn(): void {
    if (!this.#guest) return;
    const { trace, earlier, time } = this.#guest.own;
    if (!trace) {
      this.clear(this.#empty);
      return;
    }
    this.#guest = null;
    this.#earlier = earlier;
    this.#runner.open(trace);
    this.player.pause();
    this.player.seek(time);
  }

  /** Compares the run on show with another one than the run before it. */
  compareWith(earlier: Trace | null): void {
    this.#earlier = earlier;
    this.dispatchEvent(new Event("change"));
  }

  /** Shows the end of a run made before, beside what it was compared with; no run if it is null. */
  restore(trace: Trace | null, earlier: Trace | null): void {
    if (!trace) {
      this.clear(this.#empty);
      return;
    }
    this.#showEnd(trace);
    this.compareWith(earlier);
  }

  /** Forgets every run; this is the world before any. */
  clear(empty: Trace): void {
    this.#guest = null;
    this.#earlier = null;
    this.#empty = empty;
    this.#repeat.clear();
    this.#runner.clear();
    this.player.show(empty);
  }

  /** Another run comes: the one on show is what it is compared with, unless it was a guest. */
  #leaveRun(): void {
    this.#repeat.clear();
    this.#earlier = this.#guest ? this.#guest.own.trace : this.trace;
    this.#guest = null;
  }

  #show(trace: Trace, end: boolean): void {
    this.player.show(trace);
    this.#options.onShow(trace);
    if (end) this.player.toEnd();
    else this.#options.onPlay();
  }

  /** The end of one run of the series, with nothing to compare it with but the others. */
  #showEnd(trace: Trace): void {
    this.#guest = null;
    this.#earlier = null;
    this.#runner.open(trace);
    this.player.toEnd();
  }

  #ended(trace: Trace): void {
    const { end, fault } = trace;
    if (fault?.line) this.#options.onFault(fault.line, fault.message);
    // Where it went wrong or was stopped is what one wants to see, not how it began.
    if (end?.status !== "finished") this.player.toEnd();
  }
}
