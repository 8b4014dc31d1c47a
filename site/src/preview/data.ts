/**
 * What the development server tells the authors' page of a lesson: the tasks with their programs, and
 * what marking them came to. `site/build/preview` writes it. Imports types of `trace`.
 */
import type { World } from "../trace/events.ts";

export const KINDS = ["starter", "solution", "right", "wrong"] as const;
export type Kind = (typeof KINDS)[number];

/** A cause that a check.py can tell. */
export interface Cause {
  text: string;
  /** The hint that helps, 0 first. */
  hint: number | null;
  /** Where it stands in check.py. */
  line: number | null;
}

/** What marking a program came to. */
export interface Told {
  /** As the judge gave it: `runtime/marks.ts` reads it. */
  mark: unknown;
  causes: readonly Cause[];
  /** That the marking took. */
  seconds: number;
  /** Whether there is a run to see of the check that failed. */
  hasRun: boolean;
}

export interface ProgramFile {
  kind: Kind;
  /** From the task's folder. */
  file: string;
  /** Of a right solution its style, of a wrong attempt the words it should earn; else nothing. */
  note: string;
  /** The program with its words coloured. */
  html: string;
  /** By all that its mark depends on. */
  key: string;
  /** Null if it is not marked yet. */
  told: Told | null;
}

/** An entry of equivalent.json; what is left out may be any. */
export interface Reason {
  in?: string;
  /** The lines before, an arrow, and the lines after. */
  change?: string;
  kinds?: readonly string[];
  why: string;
}

/** A small change of the solution that still passes. */
export interface Change {
  /** The function that it is in; empty outside all of them. */
  in: string;
  kind: string;
  line: number;
  before: string;
  after: string;
  /** Why it is no mistake; null if nobody has said so. */
  why: string | null;
}

/** What became of the small changes of a solution. */
export interface Mutants {
  mutants: number;
  killed: number;
  explained: readonly Change[];
  open: readonly Change[];
  /** What is wrong with equivalent.json, or with what was to be tried. */
  faults: readonly string[];
  seconds: number;
}

export interface TaskPreview {
  name: string;
  /** Title, statement and hints are HTML. */
  title: string;
  statement: string;
  hints: readonly string[];
  files: readonly ProgramFile[];
  reasons: readonly Reason[];
  /** Null if they have not been tried since something changed. */
  mutants: Mutants | null;
}

export interface LessonPreview {
  slug: string;
  code: string;
  title: string;
  tasks: readonly TaskPreview[];
  /** Why there are no tasks to show; null if all is well. */
  trouble: string | null;
  /** All lessons of the course, to go to. */
  lessons: readonly { slug: string; code: string; title: string }[];
}

/** The run in which a check failed. */
export interface FailedRun {
  place: { world: World; seed: number };
  trace: unknown;
}

export function readPreview(page: Document): LessonPreview {
  const text = page.getElementById("preview-data")?.textContent;
  if (!text) throw new Error("the page has no #preview-data");
  return JSON.parse(text) as LessonPreview;
}
