/**
 * What a lesson tells a platform: its status, its score, and the progress to go on from. Pure.
 * May import `page/progress-record` (how progress is written).
 */
import { keyOf, type ProgressRecord } from "../page/progress-record.ts";
import { writeSuspended } from "./scorm-data.ts";

/** A lesson as its page's data tells it. */
export interface Lesson {
  lesson: string;
  tasks: Record<string, { stretch?: boolean }>;
}

/**
 * The values to set. The score is the share of the tasks that are passed [%], of those that are not
 * for stretching; with all of them the lesson is passed. A lesson without tasks has no score, and is
 * completed when it has been read to its end. Without `keepsData` what the platform holds is left alone:
 * it is somebody else's.
 */
export function reportOf(
  lesson: Lesson,
  progress: ProgressRecord,
  before: string,
  readToEnd: boolean,
  keepsData = true,
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
    ...(keepsData ? { "cmi.suspend_data": writeSuspended(lesson.lesson, progress) } : {}),
  };
  if (wanted.length === 0) return report;
  return {
    ...report,
    "cmi.core.score.min": "0",
    "cmi.core.score.max": "100",
    "cmi.core.score.raw": String(Math.round((100 * passed) / wanted.length)),
  };
}

function isDone(status: string): boolean {
  return status === "passed" || status === "completed";
}
