/**
 * The runs that a mark reports, read and checked: figures against limits, map, path, points. The
 * shapes are those of `py/grader/results.py`. May import the trace.
 *
 * Fetched with the first mark that has any: most tasks have none.
 */
import type { World } from "../trace/events.ts";
import { isList, isRecord } from "./shape.ts";

/** A number of a run, and the limits it has to keep. */
export interface Figure {
  name: string;
  /** Null if the run left nothing to take it from. */
  value: number | null;
  unit: string;
  /** To be shown after the point. */
  digits: number;
  at_least: number | null;
  at_most: number | null;
  /** Null for a figure without a limit. */
  met: boolean | null;
}

/** What a run has drawn: one letter a cell, row after row from the bottom of the mat. */
export interface ResultMap {
  across: number;
  cell_cm: number;
  cells: string;
}

/** The letters of a map. */
export const CELL = {
  unknown: "?",
  free: ".",
  occupied: "#",
  /** Occupied, with nothing real near. */
  wrongWall: "!",
  /** Free, inside something solid. */
  wrongFloor: "x",
} as const;

/** One run of a check. */
export interface Result {
  /** Place of its check in the mark. */
  check: number;
  world: World;
  seed: number;
  job: string;
  /** Why it stopped, in words. */
  why: string;
  figures: readonly Figure[];
  points: number | null;
  passed: boolean;
  map: ResultMap | null;
  /** Places the robot has been at [cm]. */
  path: readonly (readonly [x: number, y: number])[];
}

const MOST = { figures: 40, cells: 40_000, places: 1000, text: 2000 } as const;

/** The results of a mark. Throws an Error that says which is not what it should be. */
export function readResults(results: readonly unknown[]): Result[] {
  return results.map((result, i) => {
    if (isResult(result)) return result;
    throw new Error(`result ${i + 1} of the mark can't be read`);
  });
}

function isResult(value: unknown): value is Result {
  return (
    isRecord(value) &&
    isNumber(value.check) &&
    isWorld(value.world) &&
    isNumber(value.seed) &&
    isText(value.job) &&
    isText(value.why) &&
    isList(value.figures, MOST.figures, isFigure) &&
    isNumberOrNull(value.points) &&
    typeof value.passed === "boolean" &&
    (value.map === null || isMap(value.map)) &&
    isList(value.path, MOST.places, isPlace)
  );
}

function isFigure(value: unknown): boolean {
  return (
    isRecord(value) &&
    isText(value.name) &&
    isNumberOrNull(value.value) &&
    isText(value.unit) &&
    isNumber(value.digits) &&
    value.digits >= 0 &&
    value.digits <= 10 &&
    isNumberOrNull(value.at_least) &&
    isNumberOrNull(value.at_most) &&
    (value.met === null || typeof value.met === "boolean")
  );
}

function isMap(value: unknown): boolean {
  return (
    isRecord(value) &&
    isNumber(value.across) &&
    isNumber(value.cell_cm) &&
    value.cell_cm > 0 &&
    typeof value.cells === "string" &&
    value.cells.length <= MOST.cells &&
    value.cells.length === value.across * value.across
  );
}

/** What is drawn of a world. */
function isWorld(value: unknown): boolean {
  return (
    isRecord(value) &&
    isText(value.name) &&
    isText(value.title) &&
    Array.isArray(value.obstacles) &&
    isRecord(value.start)
  );
}

function isPlace(value: unknown): boolean {
  return Array.isArray(value) && value.length === 2 && value.every(isNumber);
}

function isText(value: unknown): boolean {
  return typeof value === "string" && value.length <= MOST.text;
}

function isNumber(value: unknown): value is number {
  return Number.isFinite(value);
}

function isNumberOrNull(value: unknown): boolean {
  return value === null || isNumber(value);
}
