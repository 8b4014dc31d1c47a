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
  /** Of a task whose mark has a score: by the way to count that is in force here. */
  score?: ScoreRecord;
  /** By other ways to count (another maximum): they can't be compared, and none is lost. */
  others?: readonly ScoreRecord[];
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
export const MOST_TASKS = 5000;
const MOST_HINTS = 20;
const MOST_SCORES = 20;
/** The last moment that a date can tell [ms since 1970]. */
const LAST_MOMENT = 8.64e15;
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

/**
 * What `writeProgress` wrote, or why it can't be read. A last place that is none is left out. A file from
 * elsewhere has so many tasks at most.
 */
export function readProgress(text: string, most = MOST_TASKS): ProgressRecord | Unreadable {
  const { record, wrong } = readAll(text);
  return wrong ?? (record.tasks.size > most ? "damaged" : record);
}

export interface ReadAll {
  /** As much as can be read. */
  record: ProgressRecord;
  /** What is wrong with the text, or null. */
  wrong: Unreadable | null;
  /** Nothing has been left out: no task, and no score that is none. */
  whole: boolean;
}

/** As much of a text as can be read. */
export function readAll(text: string): ReadAll {
  const none = (wrong: Unreadable) => ({ record: NO_PROGRESS, wrong, whole: false });
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return none(text.includes(`"${FORMAT}"`) ? "damaged" : "no progress");
  }
  if (!isRecord(value) || value.format !== FORMAT) return none("no progress");
  if (typeof value.version === "number" && value.version > VERSION) return none("newer");
  if (value.version !== VERSION || !isRecord(value.tasks)) return none("damaged");
  const tasks = new Map<string, TaskRecord>();
  let wrong: Unreadable | null = null;
  let whole = true;
  for (const [key, task] of Object.entries(value.tasks)) {
    if (isKey(key) && isTask(task)) {
      tasks.set(key, plain(task));
      whole &&= task.score === undefined || isScore(task.score);
      whole &&= task.others === undefined || isScores(task.others);
    } else wrong = "damaged";
  }
  const last = isPlace(value.last) ? value.last : null;
  return { record: { tasks, last }, wrong, whole: whole && wrong === null };
}

/** The task without what is none of the format's. */
function plain({ state, hints, solution, at, score, others }: TaskRecord): TaskRecord {
  const scores = isScores(others) ? others.map(plainScore) : [];
  return {
    ...{ state, hints, solution, at },
    ...(isScore(score) ? { score: plainScore(score) } : {}),
    ...(scores.length > 0 ? { others: scores } : {}),
  };
}

function plainScore({ best, bestAt, last, lastAt, of }: ScoreRecord): ScoreRecord {
  return { best, bestAt, last, lastAt, of };
}

/**
 * Both together: nothing that either has is lost. The last place, and the way to count scores, is that
 * of the first.
 */
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
  const [score, ...others] = mergedScores([...scoresOf(one), ...scoresOf(other)]);
  return {
    state: passes.length > 0 ? "passed" : "tried",
    hints: Math.max(one.hints, other.hints),
    solution: one.solution || other.solution,
    at: passes.length > 0 ? Math.min(...passes) : Math.max(one.at, other.at),
    ...(score ? { score } : {}),
    ...(others.length > 0 ? { others } : {}),
  };
}

/** From now on scores of this task count by this maximum. */
export function countedBy(task: TaskRecord, of: number): TaskRecord {
  const scores = scoresOf(task);
  const score = scores.find((one) => one.of === of);
  if (!score) return task;
  const others = scores.filter((one) => one !== score);
  return { ...task, score, ...(others.length > 0 ? { others } : {}) };
}

function scoresOf({ score, others = [] }: TaskRecord): ScoreRecord[] {
  return score ? [score, ...others] : [...others];
}

/** One for each maximum, in the order in which they first come. */
function mergedScores(scores: readonly ScoreRecord[]): ScoreRecord[] {
  const merged = new Map<number, ScoreRecord>();
  for (const score of scores) {
    const known = merged.get(score.of);
    merged.set(score.of, known ? mergedScore(known, score) : score);
  }
  return [...merged.values()];
}

/** The better best and the later last, of two that count alike. */
function mergedScore(one: ScoreRecord, other: ScoreRecord): ScoreRecord {
  const [earlier, later] = one.lastAt <= other.lastAt ? [one, other] : [other, one];
  if (later.best > earlier.best) return later;
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
    isMoment(value.at)
  );
}

function isMoment(value: unknown): boolean {
  return Number.isFinite(value) && Math.abs(Number(value)) <= LAST_MOMENT;
}

function isScores(value: unknown): value is ScoreRecord[] {
  return Array.isArray(value) && value.length <= MOST_SCORES && value.every(isScore);
}

function isScore(value: unknown): value is ScoreRecord {
  return (
    isRecord(value) &&
    [value.best, value.last, value.of].every(Number.isFinite) &&
    Number(value.of) > 0 &&
    Number(value.best) <= Number(value.of) &&
    isMoment(value.bestAt) &&
    isMoment(value.lastAt)
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
