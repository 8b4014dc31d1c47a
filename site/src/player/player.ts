/**
 * What moment of a run is shown, and how it moves on: play, pause, step, speeds, seek.
 * Imports `trace` only; knows no canvas, and has its clock handed in.
 *
 * A trace may still be growing. At its end the player is then "live": it stays at the end as the
 * end moves on. Whoever appends to the trace calls `grown()`.
 */
import type { Trace } from "../trace/trace.ts";

export const SPEEDS = [0.5, 1, 2, 4, 8, 16] as const;
export type Speed = (typeof SPEEDS)[number];

/** Asks for one call at the next frame, with the time in ms; in the page requestAnimationFrame. */
export type RequestFrame = (callback: (now: number) => void) => unknown;

/** A frame that comes later than this has been held up, by a hidden tab say: no leap then [s]. */
const LONGEST_FRAME_S = 0.25;

/** A wait or a drive of many seconds is one thing the program does, but not one to leap over [s]. */
const LONGEST_STEP_S = 0.5;

/**
 * Fires `change` after anything has changed (time, trace, playing, speed), at most once a frame.
 */
export class Player extends EventTarget {
  readonly #requestFrame: RequestFrame;
  #trace: Trace;
  #time = 0;
  #playing = false;
  #live = false;
  #speed: Speed = 1;
  #frameRequested = false;
  /** When the last frame was, while playing [ms]. */
  #lastFrame: number | null = null;

  constructor(trace: Trace, requestFrame: RequestFrame) {
    super();
    this.#trace = trace;
    this.#requestFrame = requestFrame;
  }

  get trace(): Trace {
    return this.#trace;
  }

  /** The shown moment, in simulated seconds. */
  get time(): number {
    return this.#time;
  }

  get duration(): number {
    return this.#trace.duration;
  }

  get playing(): boolean {
    return this.#playing;
  }

  /** True at the end of a run that is still growing, staying there. */
  get live(): boolean {
    return this.#live && !this.#trace.complete;
  }

  /** Simulated seconds in a second. */
  get speed(): Speed {
    return this.#speed;
  }

  set speed(speed: Speed) {
    if (!SPEEDS.includes(speed)) {
      throw new RangeError(`speed should be one of ${SPEEDS.join(", ")}, not ${speed}`);
    }
    this.#speed = speed;
    this.#changed();
  }

  /** Shows another run, from its start, paused; speed stays. */
  show(trace: Trace): void {
    this.#trace = trace;
    this.#time = 0;
    this.#live = false;
    this.pause();
  }

  /** To be called when the trace has new events. */
  grown(): void {
    if (this.#live) this.#time = this.duration;
    this.#changed();
  }

  /** Plays on from here; from the start if the whole run has been shown. */
  play(): void {
    if (this.#playing) return;
    if (this.#trace.complete && this.#time >= this.duration) this.#time = 0;
    this.#playing = true;
    this.#live = false;
    this.#lastFrame = null;
    this.#changed();
  }

  pause(): void {
    this.#playing = false;
    this.#changed();
  }

  toggle(): void {
    if (this.#playing) this.pause();
    else this.play();
  }

  /** Shows the moment `t`, or the nearest there is; plays on from there if it was playing. */
  seek(t: number): void {
    if (Number.isNaN(t)) throw new RangeError("seek wants a time in seconds, not NaN");
    this.#time = Math.min(Math.max(t, 0), this.duration);
    this.#live = false;
    this.#changed();
  }

  /**
   * Pauses and goes to the next (+1) or previous (-1) time at which the program did something, or
   * half a second on the way there.
   */
  step(by: 1 | -1): void {
    const { ticks } = this.#trace;
    const here = ticks.lastUpTo(this.#time);
    const between = ticks.at(here) < this.#time;
    const index = Math.max(0, by === 1 ? here + 1 : between ? here : here - 1);
    const tick = index < ticks.length ? ticks.at(index) : this.duration;
    this.pause();
    this.seek(
      by === 1
        ? Math.min(tick, this.#time + LONGEST_STEP_S)
        : Math.max(tick, this.#time - LONGEST_STEP_S),
    );
  }

  toStart(): void {
    this.pause();
    this.seek(0);
  }

  /** Pauses at the end; while the run is still growing, stays with its end. */
  toEnd(): void {
    this.pause();
    this.seek(this.duration);
    this.#live = true;
  }

  #changed(): void {
    if (this.#frameRequested) return;
    this.#frameRequested = true;
    this.#requestFrame((now) => this.#frame(now));
  }

  #frame(now: number): void {
    this.#frameRequested = false;
    if (this.#playing) this.#advance(now);
    this.dispatchEvent(new Event("change"));
  }

  #advance(now: number): void {
    const elapsed = this.#lastFrame === null ? 0 : (now - this.#lastFrame) / 1000;
    this.#lastFrame = now;
    const t = this.#time + Math.min(elapsed, LONGEST_FRAME_S) * this.#speed;
    this.#time = Math.min(t, this.duration);
    if (t < this.duration) this.#changed();
    else if (this.#trace.complete) this.#playing = false;
    // Nothing changes until the trace has grown: the program has the machine to itself.
    else this.#lastFrame = null;
  }
}
