/**
 * What a lesson tells a platform: its status, its score, and the progress to go on from. Pure.
 * May import `page/progress-record` (how progress is written).
 */
import {
  keyOf,
  NO_PROGRESS,
  type ProgressRecord,
  readProgress,
  writeProgress,
} from "../page/progress-record.ts";

/** A lesson as its page's data tells it. */
export interface Lesson {
  lesson: string;
  tasks: Record<string, { stretch?: boolean }>;
}

/** SCORM 1.2 promises room for so many characters. */
const MOST_CHARACTERS = 4096;

/**
 * The values to set. The score is the share of the tasks that are passed [%], of those that are not
 * for stretching; with all of them the lesson is passed. A lesson without tasks has no score, and is
 * completed when it has been read to its end.
 */
export function reportOf(
  lesson: Lesson,
  progress: ProgressRecord,
  before: string,
  readToEnd: boolean,
): Record<string, string> {
  const wanted = Object.entries(lesson.tasks).filter(([, { stretch }]) => !stretch);
  const passed = wanted.filter(
    ([task]) => progress.tasks.get(keyOf(lesson.lesson, task))?.state === "passed",
  ).length;
  const done = wanted.length > 0 ? passed === wanted.length : readToEnd;
  const success = wanted.length > 0 ? "passed" : "completed";
  const report: Record<string, string> = {
    // What has been passed once stays so.
    "cmi.core.lesson_status": done ? success : isDone(before) ? before : "incomplete",
    "cmi.suspend_data": suspended(lesson, progress),
  };
  if (wanted.length === 0) return report;
  return {
    ...report,
    "cmi.core.score.min": "0",
    "cmi.core.score.max": "100",
    "cmi.core.score.raw": String(Math.round((100 * passed) / wanted.length)),
  };
}

/** Progress as the platform keeps it: of this lesson alone, as short as can be. */
function suspended(lesson: Lesson, progress: ProgressRecord): string {
  const own = [...progress.tasks].filter(([key]) => key.startsWith(`${lesson.lesson}/`));
  const text = writeSmall({ tasks: new Map(own), last: null });
  if (text.length <= MOST_CHARACTERS) return text;
  // Too many tasks for it all: what is passed matters most.
  const passed = own.filter(([, { state }]) => state === "passed");
  const short = writeSmall({ tasks: new Map(passed), last: null });
  return short.length <= MOST_CHARACTERS ? short : writeSmall(NO_PROGRESS);
}

function writeSmall(progress: ProgressRecord): string {
  return JSON.stringify(JSON.parse(writeProgress(progress)));
}

/** What the page's progress holds, read from its own text. */
export function recordIn(text: string): ProgressRecord {
  const record = readProgress(text);
  return typeof record === "string" ? NO_PROGRESS : record;
}

function isDone(status: string): boolean {
  return status === "passed" || status === "completed";
}
