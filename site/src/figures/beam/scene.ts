/**
 * What one beam says of the cells of a grid under each rule: the state of the figure as numbers,
 * before anything is drawn. May import `geometry`.
 */
import {
  type Cell,
  cellAt,
  clearLength,
  crossed,
  endOfBeam,
  FAR_CM,
  type Point,
  passedByBresenham,
  stepPoints,
} from "./geometry.ts";

/** A piece of mat, with cells large enough to be counted on a phone [cm]. */
export const WIDE_CM = 200;
export const HIGH_CM = 120;
export const CELL_CM = 10;

export const RULES = ["half", "whole", "bresenham"] as const;
export type Rule = (typeof RULES)[number];

/** Where the robot stands, and where its beam ended. */
export interface Beam {
  start: Point;
  end: Point;
}

/** Beams to begin from; the first is a slant at which whole-cell steps miss some cells. */
export const EXAMPLES = {
  slant: { start: { x: 13, y: 16 }, end: { x: 141, y: 97 } },
  row: { start: { x: 25, y: 55 }, end: { x: 165, y: 55 } },
  far: { start: { x: 8, y: 20 }, end: { x: 192, y: 62 } },
} as const satisfies Record<string, Beam>;

export const FIRST_RULE: Rule = "half";

export interface Reading {
  /** What the sensor reads [cm], and at what angle [degrees clockwise from up the mat]. */
  cm: number;
  angle: number;
  /** The floor is free so far [cm], to this point. */
  clear: number;
  clearEnd: Point;
  /** The cell that gets the hit; null for a reading of nothing. */
  hit: Cell | null;
}

export interface Passed {
  /** Where the rule asks which cell it is in; none for Bresenham's, which asks nowhere. */
  looks: Point[];
  /** The cells it names, each once. */
  cells: Cell[];
  /** Cells that the beam crosses on the way, and the rule leaves out. */
  missed: Cell[];
  /** The longest way of the beam in one of those [cm]; 0 if there is none. */
  longestMissed: number;
  /** Cells that it names although the beam does not cross them. */
  beside: Cell[];
}

export function readingOf({ start, end }: Beam): Reading {
  const [right, up] = [end.x - start.x, end.y - start.y];
  const cm = Math.hypot(right, up);
  const angle = (Math.atan2(right, up) * 180) / Math.PI;
  const clear = clearLength(cm, CELL_CM);
  const clearEnd = endOfBeam(start, angle, clear);
  return { cm, angle, clear, clearEnd, hit: cm < FAR_CM ? cellAt(end, CELL_CM) : null };
}

export function passedBy(rule: Rule, start: Point, { angle, clear, clearEnd }: Reading): Passed {
  const byLine = rule === "bresenham";
  const looks = byLine ? [] : stepPoints(start, angle, clear, stepOf(rule));
  const named = byLine
    ? passedByBresenham(start, angle, clear, CELL_CM)
    : looks.map((point) => cellAt(point, CELL_CM));
  const cells = distinct(named);
  // Steps are held only to the way between the first and the last: what is beyond is not asked.
  const last = byLine ? clearEnd : looks.at(-1);
  const way = last ? crossed(start, last, CELL_CM) : [];
  const missed = way.filter(({ cell }) => !has(cells, cell));
  return {
    looks,
    cells,
    missed: missed.map(({ cell }) => cell),
    longestMissed: Math.max(0, ...missed.map(({ cm }) => cm)),
    beside: cells.filter((cell) => !way.some((stretch) => same(stretch.cell, cell))),
  };
}

/** How far a walk goes from one look to the next [cm]. */
export function stepOf(rule: "half" | "whole"): number {
  return rule === "half" ? CELL_CM / 2 : CELL_CM;
}

/** A point kept on the piece of mat, in whole centimetres, with room for the robot. */
export function onMat({ x, y }: Point): Point {
  const within = (value: number, most: number): number =>
    Math.min(most - MARGIN_CM, Math.max(MARGIN_CM, Math.round(value)));
  return { x: within(x, WIDE_CM), y: within(y, HIGH_CM) };
}

const MARGIN_CM = 5;

const same = (a: Cell, b: Cell): boolean => a[0] === b[0] && a[1] === b[1];

function distinct(cells: readonly Cell[]): Cell[] {
  return cells.filter((cell, at) => cells.findIndex((other) => same(other, cell)) === at);
}

function has(cells: readonly Cell[], cell: Cell): boolean {
  return cells.some((other) => same(other, cell));
}
