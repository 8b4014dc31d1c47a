/**
 * What the judge says, read and checked: the jobs it wants done, and the mark. The shapes are those
 * of `py/grader`. May import the trace.
 */
import type { World } from "../trace/events.ts";
import { isList, isRecord } from "./shape.ts";

export type CheckStatus = "passed" | "failed" | "not run";

/** Where on the mat a check failed. */
export interface Where {
  world: World;
  /** Column and row of each cell, from the mat's lower left corner. */
  cells: readonly (readonly [column: number, row: number])[];
  /** Side of a cell [cm]. */
  cell_cm: number;
  /** The moment of the run [s]; null for its end. */
  seconds: number | null;
  /** The job whose run shows it; null if there is no run to see. */
  job: string | null;
}

/** One check of a mark. What it expected and got is told of the first that failed. */
export interface CheckMark {
  title: string;
  status: CheckStatus;
  expected: string | null;
  got: string | null;
  where: Where | null;
  /** The common mistake it looks like. */
  likely: string | null;
  /** The hint that helps, 0 first. */
  hint: number | null;
}

/** What the runs of a project are worth together. */
export interface Score {
  value: number;
  /** The most there can be. */
  of: number;
  /** What counts, in words. */
  how: string;
}

export interface Mark {
  format: 1;
  lesson: string;
  task: string;
  passed: boolean;
  checks: readonly CheckMark[];
  /** The runs it reports: `readResults` reads them. */
  results: readonly unknown[];
  score: Score | null;
  /** Set if marking failed through a fault of ours: what happened. */
  ours: string | null;
}

/** A job as far as the page acts on it. */
export interface Job {
  id: string;
  /** The longest it may take, and the longest a run may compute with no simulated time passing [s]. */
  limits: { real_s: number; silent_s: number };
  /**
   * Where the program is run, for a job that is a run; its trace can be shown. `number` is the seed as
   * the check names it: the noise itself is made of the program's text as well.
   */
  place: { world: World; seed: number; number: number } | null;
  /** The whole job as the judge wrote it, for the performer: its numbers keep their kind. */
  text: string;
}

export type Step = { jobs: readonly Job[] } | { mark: Mark };

/** Most jobs of one step, checks and results of a mark, cells of one place, characters of a text. */
const MOST = { jobs: 500, checks: 200, results: 500, cells: 40_000, text: 50_000 } as const;

/** What a judge sent as a `step`. Throws an Error that says what is wrong with it. */
export function readStep(text: string): Step {
  const step: unknown = JSON.parse(text);
  if (isRecord(step) && isList(step.jobs, MOST.jobs, isText)) {
    return { jobs: step.jobs.map((job) => readJob(String(job))) };
  }
  if (isRecord(step) && isMark(step.mark)) return { mark: step.mark };
  throw new Error(`the judge gave neither jobs nor a mark: ${text.slice(0, 200)}`);
}

function readJob(text: string): Job {
  const job: unknown = JSON.parse(text);
  if (isRecord(job) && isText(job.id) && isRecord(job.limits)) {
    const { id, kind, world, seed, number, limits } = job;
    const { real_s, silent_s } = limits;
    const isRun = kind === "run" && isWorld(world) && isWhole(seed) && isWhole(number);
    const place = isRun ? { world, seed, number } : null;
    if (isPositive(real_s) && isPositive(silent_s)) {
      return { id, limits: { real_s, silent_s }, place, text };
    }
  }
  throw new Error(`the judge asked for what is no job: ${text.slice(0, 200)}`);
}

function isMark(value: unknown): value is Mark {
  return (
    isRecord(value) &&
    value.format === 1 &&
    isText(value.lesson) &&
    isText(value.task) &&
    typeof value.passed === "boolean" &&
    isTextOrNull(value.ours) &&
    isList(value.checks, MOST.checks, isCheck) &&
    isList(value.results, MOST.results, isRecord) &&
    (value.score === null || isScore(value.score))
  );
}

function isScore(value: unknown): boolean {
  return (
    isRecord(value) &&
    Number.isFinite(value.value) &&
    isPositive(value.of) &&
    isText(value.how) &&
    value.how.length <= MOST.text
  );
}

function isCheck(value: unknown): boolean {
  return (
    isRecord(value) &&
    isText(value.title) &&
    ["passed", "failed", "not run"].includes(String(value.status)) &&
    isTextOrNull(value.expected) &&
    isTextOrNull(value.got) &&
    isTextOrNull(value.likely) &&
    (value.hint === null || (isWhole(value.hint) && value.hint >= 0)) &&
    (value.where === null || isWhere(value.where))
  );
}

function isWhere(value: unknown): boolean {
  return (
    isRecord(value) &&
    isWorld(value.world) &&
    isList(value.cells, MOST.cells, isPair) &&
    isPositive(value.cell_cm) &&
    (value.seconds === null || Number.isFinite(value.seconds)) &&
    isTextOrNull(value.job)
  );
}

/** What the page draws of a world; the judge and the performer read the rest. */
function isWorld(value: unknown): value is World {
  return (
    isRecord(value) &&
    isText(value.name) &&
    isText(value.title) &&
    Array.isArray(value.obstacles) &&
    isRecord(value.start)
  );
}

function isText(value: unknown): value is string {
  return typeof value === "string";
}

function isTextOrNull(value: unknown): boolean {
  return value === null || (isText(value) && value.length <= MOST.text);
}

function isWhole(value: unknown): value is number {
  return Number.isSafeInteger(value);
}

function isPositive(value: unknown): value is number {
  return Number.isFinite(value) && Number(value) > 0;
}

function isPair(value: unknown): boolean {
  return Array.isArray(value) && value.length === 2 && value.every(isWhole);
}
