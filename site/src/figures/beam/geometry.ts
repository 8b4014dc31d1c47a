/**
 * The cells a beam passes, by three rules: `py/mapping/beam.py` again for figures that move, held
 * equal to it by tests/golden/beams.json. May import `trace/frames`.
 */
import { direction } from "../../trace/frames.ts";

export interface Point {
  x: number;
  y: number;
}

/** (column, row), counted from the lower left corner. */
export type Cell = readonly [column: number, row: number];

/** A reading this long or longer is not a wall [cm]. */
export const FAR_CM = 170;

/** The point a length [cm] away at an angle [degrees clockwise from up the mat]. */
export function endOfBeam({ x, y }: Point, angleDeg: number, lengthCm: number): Point {
  const [dx, dy] = direction(angleDeg);
  return { x: x + lengthCm * dx, y: y + lengthCm * dy };
}

/** How far along its beam a reading speaks for free floor [cm]: to one cell short of a hit. */
export function clearLength(readingCm: number, cellCm: number): number {
  return readingCm >= FAR_CM ? FAR_CM : Math.max(0, readingCm - cellCm);
}

/** The cell that holds a point; it may lie beyond the mat. */
export function cellAt({ x, y }: Point, cellCm: number): Cell {
  return [Math.floor(x / cellCm), Math.floor(y / cellCm)];
}

/** The points at which a walk along the beam asks which cell it is in, its start among them. */
export function stepPoints(
  start: Point,
  angleDeg: number,
  lengthCm: number,
  stepCm: number,
): Point[] {
  const count = Math.trunc(lengthCm / stepCm);
  return Array.from({ length: count }, (_, i) => endOfBeam(start, angleDeg, i * stepCm));
}

/** The cell at each of those points: some more than once, and with long steps some left out. */
export function passedBySteps(
  start: Point,
  angleDeg: number,
  lengthCm: number,
  cellCm: number,
  stepCm: number,
): Cell[] {
  return stepPoints(start, angleDeg, lengthCm, stepCm).map((point) => cellAt(point, cellCm));
}

/** A line of cells from the one that holds the start to the one at the length, each once. */
export function passedByBresenham(
  start: Point,
  angleDeg: number,
  lengthCm: number,
  cellCm: number,
): Cell[] {
  const end = endOfBeam(start, angleDeg, lengthCm);
  return bresenham(cellAt(start, cellCm), cellAt(end, cellCm));
}

/**
 * The cells of a line between two cells, both included (Bresenham 1965): one along the longer side
 * at each step, and sideways too whenever the true line is more than half a cell away.
 */
export function bresenham(first: Cell, last: Cell): Cell[] {
  let [column, row] = first;
  const wide = Math.abs(last[0] - column);
  const high = Math.abs(last[1] - row);
  const right = last[0] >= column ? 1 : -1;
  const up = last[1] >= row ? 1 : -1;
  const longer = Math.max(wide, high);
  const shorter = Math.min(wide, high);
  const line: Cell[] = [first];
  // What is left of the half cell, times twice the longer side, so that it stays whole.
  let drift = longer;
  for (let i = 0; i < longer; i++) {
    drift -= 2 * shorter;
    const sideways = drift < 0;
    if (sideways) drift += 2 * longer;
    if (wide >= high || sideways) column += right;
    if (wide < high || sideways) row += up;
    line.push([column, row]);
  }
  return line;
}

/** A cell on a way, and how much of the way is in it [cm]. */
export interface Stretch {
  cell: Cell;
  cm: number;
}

/**
 * Every cell that the straight way between two points really crosses, in order, however small the
 * corner (Amanatides and Woo 1987): from one grid line to the next, whichever comes first.
 */
export function crossed(from: Point, to: Point, cellCm: number): Stretch[] {
  let [column, row] = cellAt(from, cellCm);
  const x = edges(from.x, to.x - from.x, column, cellCm);
  const y = edges(from.y, to.y - from.y, row, cellCm);
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  const stretches: Stretch[] = [];
  let here = 0;
  const leave = (next: number): void => {
    stretches.push({ cell: [column, row], cm: (next - here) * length });
    here = next;
  };
  // A share of the way below 1 is before its end.
  for (let next = Math.min(x.next, y.next); next < 1; next = Math.min(x.next, y.next)) {
    leave(next);
    // Through a corner both lines are met at once, but for what rounding leaves.
    const both = next + 1e-9;
    if (x.next <= both) {
      column += x.by;
      x.next += x.apart;
    }
    if (y.next <= both) {
      row += y.by;
      y.next += y.apart;
    }
  }
  leave(1);
  // A way that ends on a grid line ends in the cell that the line belongs to.
  const last = cellAt(to, cellCm);
  if (column !== last[0] || row !== last[1]) stretches.push({ cell: last, cm: 0 });
  return stretches;
}

/** Along one axis: the share of the way to the next grid line, and from each line to the one after. */
function edges(
  from: number,
  way: number,
  at: number,
  cellCm: number,
): { next: number; apart: number; by: 1 | -1 } {
  const by = way >= 0 ? 1 : -1;
  if (way === 0) return { next: Number.POSITIVE_INFINITY, apart: 0, by };
  const line = (by === 1 ? at + 1 : at) * cellCm;
  return { next: (line - from) / way, apart: cellCm / Math.abs(way), by };
}
