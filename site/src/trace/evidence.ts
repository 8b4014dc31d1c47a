/**
 * Why a cell of a map is what it is: the beams of the run that passed through it and those that
 * ended in it, whatever the program made of them. From the scans and the true poses they were
 * taken from. Imports the trace and `frames`.
 *
 * What counts as passing is the lessons' rule: a beam goes in steps of half a cell up to one cell short
 * of its end. One that crosses a cell only behind its last step is counted by itself.
 *
 * The geometry is exact: a cell holds its lower and left edges and not its upper and right ones,
 * so a beam along an edge or through a corner belongs to one cell only.
 */
import { type Cell, direction } from "./frames.ts";
import type { Trace } from "./trace.ts";

/** Readings this long or longer mark no wall, and a beam goes on for its steps only so far [cm]. */
export const HIT_LIMIT_CM = 170;

/** One beam of one scan, from the robot to where it ended. */
export interface Beam {
  t: number;
  /** From the robot's centre… */
  x: number;
  y: number;
  /** …to where the reading says the beam stopped. */
  endX: number;
  endY: number;
  /** What the sensor read [cm]. */
  reading: number;
  /** What it did to the cell that was asked about. */
  did: Touch;
}

/** Passed through it, ended in it, or ended so close behind it that it says nothing. */
export type Touch = "passed" | "ended" | "close";

export interface CellEvidence {
  passed: number;
  ended: number;
  close: number;
  /** The last beam that touched the cell, or null if none has. */
  last: Beam | null;
}

/** Numbers of a beam in the flat store. */
const T = 0;
const X = 1;
const Y = 2;
const END_X = 3;
const END_Y = 4;
const READING = 5;
const STRIDE = 6;

type Counts = Record<Touch, number>;
const NONE: Counts = { passed: 0, ended: 0, close: 0 };

export class Evidence {
  readonly #trace: Trace;
  /** t, x, y, endX, endY, reading of each beam, in order of time. */
  #beams = new Float64Array(0);
  #count = 0;
  #scansRead = 0;
  /** The beams that touched the cell asked about last: it is asked again at every frame. */
  #cell: Cell = { x: 0, y: 0, size: 0 };
  #touching: ({ beam: number; did: Touch } & Counts)[] = [];
  #beamsSearched = 0;

  constructor(trace: Trace) {
    this.#trace = trace;
  }

  /** What the beams up to a time say about a cell. */
  of(cell: Cell, t: number): CellEvidence {
    this.#readNewScans();
    if (!sameCell(cell, this.#cell)) {
      this.#cell = cell;
      this.#touching = [];
      this.#beamsSearched = 0;
    }
    this.#search();
    const upTo = this.#touching[this.#lastTouchUpTo(t)];
    if (!upTo) return { ...NONE, last: null };
    const { beam, did, passed, ended, close } = upTo;
    return { passed, ended, close, last: this.#beam(beam, did) };
  }

  #readNewScans(): void {
    this.#trace.forEachBeam(this.#scansRead, (t, x, y, heading, angle, reading) => {
      const i = STRIDE * this.#count++;
      if (i === this.#beams.length) {
        const wider = new Float64Array(Math.max(STRIDE * 256, 2 * i));
        wider.set(this.#beams);
        this.#beams = wider;
      }
      const [right, up] = direction(heading + angle);
      this.#beams[i + T] = t;
      this.#beams[i + X] = x;
      this.#beams[i + Y] = y;
      this.#beams[i + END_X] = x + reading * right;
      this.#beams[i + END_Y] = y + reading * up;
      this.#beams[i + READING] = reading;
    });
    this.#scansRead = this.#trace.scanCount;
  }

  /** Goes through the beams that have come since this cell was last asked about. */
  #search(): void {
    const numbers = this.#beams;
    const cell = this.#cell;
    const right = cell.x + cell.size;
    const top = cell.y + cell.size;
    const counts = { ...(this.#touching.at(-1) ?? NONE) };
    for (let beam = this.#beamsSearched; beam < this.#count; beam++) {
      const i = STRIDE * beam;
      const x = numbers[i + X] as number;
      const y = numbers[i + Y] as number;
      const endX = numbers[i + END_X] as number;
      const endY = numbers[i + END_Y] as number;
      // Most beams lie wholly to one side of the cell; this is all the work they make.
      if ((x < cell.x && endX < cell.x) || (x >= right && endX >= right)) continue;
      if ((y < cell.y && endY < cell.y) || (y >= top && endY >= top)) continue;
      const did = touchOf(cell, x, y, endX, endY, numbers[i + READING] as number);
      if (!did) continue;
      counts[did] += 1;
      const { passed, ended, close } = counts;
      this.#touching.push({ beam, did, passed, ended, close });
    }
    this.#beamsSearched = this.#count;
  }

  #lastTouchUpTo(t: number): number {
    let low = 0;
    let high = this.#touching.length;
    while (low < high) {
      const middle = (low + high) >>> 1;
      const beam = this.#touching[middle]?.beam ?? 0;
      if ((this.#beams[STRIDE * beam + T] as number) <= t) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  #beam(index: number, did: Touch): Beam {
    const [t, x, y, endX, endY, reading] = this.#beams.subarray(
      STRIDE * index,
      STRIDE * (index + 1),
    ) as unknown as [number, number, number, number, number, number];
    return { t, x, y, endX, endY, reading, did };
  }
}

/** What a beam did to a cell, null if it did not touch it. */
function touchOf(
  cell: Cell,
  x: number,
  y: number,
  endX: number,
  endY: number,
  reading: number,
): Touch | null {
  const reaches = (length: number): boolean => {
    const share = length / reading;
    return (
      length >= 0 && reading > 0 && crosses(cell, x, y, share * (endX - x), share * (endY - y))
    );
  };
  const isHit = reading < HIT_LIMIT_CM;
  if (isHit && holds(cell, endX, endY)) return "ended";
  if (reaches(lastStep(isHit ? reading - cell.size : HIT_LIMIT_CM, cell.size / 2))) return "passed";
  return isHit && reaches(reading) ? "close" : null;
}

/** How far the last step of a beam is that goes in steps up to a length; negative if there is none. */
function lastStep(length: number, step: number): number {
  return (Math.floor(length / step) - 1) * step;
}

function sameCell(a: Cell, b: Cell): boolean {
  return a.x === b.x && a.y === b.y && a.size === b.size;
}

/** Whether a point lies in a cell; the upper and right edges are its neighbours'. */
export function holds(cell: Cell, x: number, y: number): boolean {
  return x >= cell.x && x < cell.x + cell.size && y >= cell.y && y < cell.y + cell.size;
}

/** Whether the segment from (x, y) by (dx, dy), ends included, has a point in a cell. */
export function crosses(cell: Cell, x: number, y: number, dx: number, dy: number): boolean {
  const column = within(x, dx, cell.x, cell.x + cell.size);
  const row = within(y, dy, cell.y, cell.y + cell.size);
  if (!column || !row) return false;
  const enter = Math.max(column.enter, row.enter);
  const leave = Math.min(column.leave, row.leave);
  if (enter !== leave) return enter < leave;
  // One point in common: in the cell unless it is on an edge that is not the cell's own.
  const beforeEntry = [column, row].some((part) => part.enter === enter && part.entersAfter);
  const beyondExit = [column, row].some((part) => part.leave === leave && part.leavesBefore);
  return !beforeEntry && !beyondExit;
}

/** The shares of a segment's length at which it is between two edges, the high one excluded. */
interface Part {
  enter: number;
  leave: number;
  /** True if it is not yet between them at `enter`, or no longer at `leave`. */
  entersAfter: boolean;
  leavesBefore: boolean;
}

/** Along one axis; null if the segment is never between the edges. */
function within(start: number, step: number, low: number, high: number): Part | null {
  if (step === 0) {
    const inside = start >= low && start < high;
    return inside ? { enter: 0, leave: 1, entersAfter: false, leavesBefore: false } : null;
  }
  const atLow = (low - start) / step;
  const atHigh = (high - start) / step;
  const enter = Math.max(0, Math.min(atLow, atHigh));
  const leave = Math.min(1, Math.max(atLow, atHigh));
  if (enter > leave) return null;
  return {
    enter,
    leave,
    entersAfter: step < 0 && enter === atHigh,
    leavesBefore: step > 0 && leave === atHigh,
  };
}
