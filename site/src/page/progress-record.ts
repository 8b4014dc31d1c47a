/**
 * What is known of a learner's way through the course, as plain data: read, checked, merged and
 * written. Pure. Imports nothing of ours.
 */

/** How far one task has come. */
export interface TaskRecord {
  state: "tried" | "passed";
  /** Hints opened; they open in order. */
  hints: number;
  /** The solution has been looked at. */
  solution: boolean;
  /** When it was first passed, or else last tried [ms since 1970]. */
  at: number;
  /** Of a task whose mark has a score. */
  score?: ScoreRecord;
}

/** The best and the last score of a task, each with its moment [ms since 1970]. */
export interface ScoreRecord {
  best: number;
  bestAt: number;
  last: number;
  lastAt: number;
  /** The most there can be. */
  of: number;
}

export interface Place {
  lesson: string;
  /** Null for the lesson as a whole. */
  task: string | null;
}

export interface ProgressRecord {
  /** By "lesson/task". */
  tasks: ReadonlyMap<string, TaskRecord>;
  last: Place | null;
}

export const NO_PROGRESS: ProgressRecord = { tasks: new Map(), last: null };

const FORMAT = "bugbot-progress";
const VERSION = 1;
/** More tasks than any course has. */
const MOST_TASKS = 5000;
const MOST_HINTS = 20;
const NAME = /^[a-z0-9][a-z0-9-]{0,99}$/;

/** Why a text is no record of progress. */
export type Unreadable = "no progress" | "newer" | "damaged";

export function keyOf(lesson: string, task: string): string {
  return `${lesson}/${task}`;
}

export function writeProgress({ tasks, last }: ProgressRecord): string {
  const format = { format: FORMAT, version: VERSION };
  return JSON.stringify({ ...format, tasks: Object.fromEntries(tasks), last }, null, 1);
}

/** What `writeProgress` wrote, or why it can't be read. A last place that is none is left out. */
export function readProgress(text: string): ProgressRecord | Unreadable {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return "no progress";
  }
  if (!isRecord(value) || value.format !== FORMAT) return "no progress";
  if (typeof value.version === "number" && value.version > VERSION) return "newer";
  if (value.version !== VERSION || !isRecord(value.tasks)) return "damaged";
  const entries = Object.entries(value.tasks);
  if (entries.length > MOST_TASKS) return "damaged";
  const tasks = new Map<string, TaskRecord>();
  for (const [key, task] of entries) {
    if (!isKey(key) || !isTask(task)) return "damaged";
    const { state, hints, solution, at, score } = task;
    tasks.set(key, { state, hints, solution, at, ...(isScore(score) ? { score } : {}) });
  }
  return { tasks, last: isPlace(value.last) ? value.last : null };
}

/** Both together: nothing that either has is lost. The last place is that of the first. */
export function merged(one: ProgressRecord, other: ProgressRecord): ProgressRecord {
  const tasks = new Map(one.tasks);
  for (const [key, theirs] of other.tasks) {
    const mine = tasks.get(key);
    tasks.set(key, mine ? mergedTask(mine, theirs) : theirs);
  }
  return { tasks, last: one.last ?? other.last };
}

function mergedTask(one: TaskRecord, other: TaskRecord): TaskRecord {
  const passes = [one, other].filter(({ state }) => state === "passed").map(({ at }) => at);
  const score = mergedScore(one.score, other.score);
  return {
    state: passes.length > 0 ? "passed" : "tried",
    hints: Math.max(one.hints, other.hints),
    solution: one.solution || other.solution,
    at: passes.length > 0 ? Math.min(...passes) : Math.max(one.at, other.at),
    ...(score ? { score } : {}),
  };
}

/** The better best and the later last. Of two ways to count, the one used last is what counts. */
function mergedScore(one?: ScoreRecord, other?: ScoreRecord): ScoreRecord | undefined {
  if (!one || !other) return one ?? other;
  const [earlier, later] = one.lastAt <= other.lastAt ? [one, other] : [other, one];
  if (earlier.of !== later.of || later.best > earlier.best) return later;
  return { ...later, best: earlier.best, bestAt: earlier.bestAt };
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function isKey(key: string): boolean {
  const names = key.split("/");
  return names.length === 2 && names.every((name) => NAME.test(name));
}

function isTask(value: unknown): value is TaskRecord {
  return (
    isRecord(value) &&
    (value.state === "tried" || value.state === "passed") &&
    Number.isSafeInteger(value.hints) &&
    Number(value.hints) >= 0 &&
    Number(value.hints) <= MOST_HINTS &&
    typeof value.solution === "boolean" &&
    Number.isFinite(value.at)
  );
}

function isScore(value: unknown): value is ScoreRecord {
  return (
    isRecord(value) &&
    [value.best, value.bestAt, value.last, value.lastAt, value.of].every(Number.isFinite)
  );
}

function isPlace(value: unknown): value is Place {
  return (
    isRecord(value) &&
    typeof value.lesson === "string" &&
    NAME.test(value.lesson) &&
    (value.task === null || (typeof value.task === "string" && NAME.test(value.task)))
  );
}
