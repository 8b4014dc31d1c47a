/**
 * What a lesson's page brings along for its labs and tasks, as the build wrote it into the page:
 * worlds, programs, and each task's starter, solution and check. Imports types of `trace`.
 */
import type { World } from "../trace/events.ts";

export interface TaskData {
  title: string;
  starter: string;
  solution: string;
  /** The text of check.py. */
  check: string;
  world: string;
  seed: number;
  /** More worlds to try the program on; none if left out. */
  practice?: readonly string[];
  /** Beyond what the lesson asks of everybody. */
  stretch: boolean;
}

export interface LessonData {
  format: 1;
  /** The lesson's folder. */
  lesson: string;
  /** "U8.2" */
  code: string;
  title: string;
  /** The lesson's own worlds, those that only checks use among them. */
  worlds: readonly World[];
  programs: Readonly<
    Record<string, { source: string; world: string; seed: number; title: string }>
  >;
  /** In the order of the page. */
  tasks: Readonly<Record<string, TaskData>>;
}

/** Null on a page that brings none. The build has checked what is in it. */
export function readLessonData(page: Document): LessonData | null {
  const text = page.getElementById("lesson-data")?.textContent;
  return text ? (JSON.parse(text) as LessonData) : null;
}
