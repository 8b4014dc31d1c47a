/**
 * Which cell is asked about: the one under the pointer, or else the one picked by a click, a touch
 * or the arrow keys. May import `trace/frames`.
 *
 * It keeps points, not cells: another moment of the run may have cells of another size.
 */
import { type Cell, cellOf, MAT_CM } from "../../trace/frames.ts";

interface Point {
  x: number;
  y: number;
}

/** With Shift the arrows move so many cells. */
const LEAP = 5;

const ARROWS: Readonly<Record<string, readonly [right: number, up: number]>> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export class CellCursor {
  #under: Point | null = null;
  #picked: Point | null = null;

  cell(sizeCm: number): Cell | null {
    const point = this.#under ?? this.#picked;
    return point && cellOf(point.x, point.y, sizeCm);
  }

  /** The pointer is there, or has left. */
  hover(point: Point | null): void {
    this.#under = point;
  }

  /** Picks the cell at a point; the one that is picked already is let go. */
  pick(point: Point, sizeCm: number): void {
    const cell = cellOf(point.x, point.y, sizeCm);
    const before = this.#picked && cellOf(this.#picked.x, this.#picked.y, sizeCm);
    const again = cell !== null && before !== null && cell.x === before.x && cell.y === before.y;
    this.#picked = again ? null : point;
  }

  drop(): void {
    this.#under = null;
    this.#picked = null;
  }

  /** Moves by a key, from `start` if nothing was picked; false if the key is none of its own. */
  key(key: string, leap: boolean, sizeCm: number, start: Point): boolean {
    const arrow = ARROWS[key];
    if (!arrow) return false;
    const from = this.#picked ?? this.#under;
    this.#under = null;
    const at = cellOf(clamp((from ?? start).x), clamp((from ?? start).y), sizeCm);
    if (!at) return false;
    const cells = from === null ? 0 : leap ? LEAP : 1;
    const half = sizeCm / 2;
    this.#picked = {
      x: clamp(at.x + half + arrow[0] * cells * sizeCm),
      y: clamp(at.y + half + arrow[1] * cells * sizeCm),
    };
    return true;
  }
}

/** On the mat; its far edges are beyond it. */
function clamp(cm: number): number {
  return Math.min(Math.max(cm, 0), MAT_CM - 1e-6);
}
