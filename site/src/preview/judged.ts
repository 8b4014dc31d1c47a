/**
 * Whether a program's mark is what it should be. Pure. Imports `runtime/marks` and the data.
 */
import { type CheckMark, type Mark, readStep } from "../runtime/marks.ts";
import type { Kind, ProgramFile, TaskPreview, Told } from "./data.ts";

export type Verdict =
  | "unmarked"
  | "marking"
  | "trouble"
  | "fails"
  | "passes"
  | "earns"
  | "should fail"
  | "should pass"
  | "earns other words";

export type Tone = "good" | "bad" | "doubt" | "none";

export const TONES: Readonly<Record<Verdict, Tone>> = {
  unmarked: "none",
  marking: "none",
  trouble: "bad",
  fails: "good",
  passes: "good",
  earns: "good",
  "should fail": "bad",
  "should pass": "bad",
  "earns other words": "bad",
};

const marks = new WeakMap<Told, Mark>();

/** The mark, checked as a learner's page checks what its judge sends. */
export function markOf(told: Told): Mark {
  const known = marks.get(told);
  if (known) return known;
  const step = readStep(JSON.stringify({ mark: told.mark }));
  if (!("mark" in step)) throw new Error("marking came to no mark");
  marks.set(told, step.mark);
  return step.mark;
}

/** The check whose details a learner reads. */
export function firstFailed(mark: Mark): CheckMark | null {
  return mark.checks.find(({ status }) => status === "failed") ?? null;
}

export function verdictOf({ kind, note, told }: ProgramFile): Verdict {
  if (!told) return "unmarked";
  const mark = markOf(told);
  if (mark.ours !== null) return "trouble";
  const passes: Readonly<Record<Kind, boolean>> = {
    ...{ starter: false, wrong: false },
    ...{ solution: true, right: true },
  };
  if (mark.passed !== passes[kind]) return mark.passed ? "should fail" : "should pass";
  if (mark.passed) return "passes";
  const failed = firstFailed(mark);
  if (kind === "starter") return "fails";
  const earned = failed?.likely ?? failed?.got ?? "";
  return note !== "" && earned.includes(note) ? "earns" : "earns other words";
}

export interface HeldCause {
  text: string;
  hint: number | null;
  line: number | null;
  /** Whether check.py declares it; else it is one that the grader tells in any task. */
  declared: boolean;
  /** The wrong attempts that are told it. */
  earnedBy: readonly string[];
}

/** Every cause of the task; null before anything of it is marked. */
export function causesOf({ files }: TaskPreview): HeldCause[] | null {
  const told = files.flatMap((file) => (file.told ? [{ ...file, told: file.told }] : []));
  if (told.length === 0) return null;
  const earned = told.flatMap(({ kind, file, told: each }) => {
    const failed = firstFailed(markOf(each));
    const text = kind === "wrong" ? failed?.likely : null;
    return text ? [{ text, file, hint: failed?.hint ?? null }] : [];
  });
  const causes = new Map<string, Omit<HeldCause, "earnedBy">>();
  for (const { causes: some } of told.map((each) => each.told)) {
    for (const cause of some) causes.set(cause.text, { ...cause, declared: true });
  }
  for (const { text, hint } of earned) {
    if (!causes.has(text)) causes.set(text, { text, hint, line: null, declared: false });
  }
  return [...causes.values()].map((cause) => ({
    ...cause,
    earnedBy: earned.filter(({ text }) => text === cause.text).map(({ file }) => file),
  }));
}
