/**
 * The words of tasks: marks, hints, solutions. `strings.ts` has the rest and the voice.
 * Imports `counted`.
 */
import { counted } from "./counted.ts";

const key = /Mac|iPhone|iPad/.test(globalThis.navigator?.userAgent ?? "") ? "⌘" : "Ctrl+";

export const taskWords = {
  place: (number: number, of: number) => `Task ${number} of ${of}`,
  stretch: "Stretch",
  states: { new: "Not tried yet", tried: "Tried", passed: "Passed" },
  next: (title: string) => `Next task: ${title}`,
};

interface Count {
  done: number;
  of: number;
  now: { mat: number; mats: number; seed: number } | null;
}

export const markWords = {
  check: "Check my work",
  checkKeys: `Check my work (${key}Shift+Enter)`,
  cancel: "Cancel",
  status: "Mark",
  progress: "Checking",
  checks: "Checks",
  none: "The robot tries your program on mats and noise you have not seen.",
  tried: "You have tried this task before. Check it again when you are ready.",
  passedBefore: (at: Date) =>
    `You passed this task on ${at.toLocaleDateString("en-GB", { day: "numeric", month: "long", year: "numeric" })}.`,
  waiting: "Python is still starting. Your program is checked as soon as it is up.",
  marking: "Checking your program…",
  /** How many tries are done, and which run is under way, if there are several. */
  count: ({ done, of, now }: Count) =>
    `${done} of ${counted(of, "try", "tries")}${now && of > 1 ? `, now mat ${now.mat} of ${now.mats}, seed ${now.seed}` : ""}`,
  cancelled: "Checking was cancelled.",
  passed: (checks: number) =>
    checks === 1 ? "Passed. The check passes." : `Passed. All ${checks} checks pass.`,
  failed: (passed: number, of: number) =>
    `Not yet: ${passed} of ${counted(of, "check passes", "checks pass")}.`,
  failedFirst: (title: string) => `Look at “${title}” first.`,
  best: ({ best, of }: { best: number; of: number }) =>
    `Your best score is ${best.toFixed(1)} of ${of}.`,
  score: ({ value, of }: { value: number; of: number }) => `Score ${value.toFixed(1)} of ${of}.`,
  stale: "Your program has changed since this mark.",
  ours: "Your program could not be marked. That is a fault of this site, not of your program.",
  oursDetail: "What went wrong",
  oursAgain: "Try again. If it happens every time, please tell whoever runs this course.",
  state: { passed: "passed", failed: "not passed", "not run": "not run" },
  expected: "Expected",
  got: "Got",
  likely: "Likely cause",
  nextHint: "Next hint",
  toHint: (number: number) => `Go to hint ${number}`,
};

export const whereWords = {
  picture: "Where on the mat",
  onWorld: (title: string) => `On “${title}”`,
  atTime: (seconds: number) => ` at ${seconds.toFixed(1)} s`,
  atEnd: " at the end of the run",
  cells: (count: number) => `, ${counted(count, "cell")} outlined.`,
  noCells: ".",
  cellList: (cells: readonly (readonly [number, number])[], most: number) =>
    `Cells (column, row): ${cells
      .slice(0, most)
      .map(([column, row]) => `(${column}, ${row})`)
      .join(", ")}${cells.length > most ? " and others" : ""}.`,
  show: "Show this run",
  showMat: "Show it on the mat",
  shown: (title: string) => `This is the check’s run on “${title}”, not yours.`,
  shownMat: (title: string) => `This is where the check failed, on “${title}”.`,
};

export const hintWords = {
  region: "Hints",
  title: (number: number, of: number) => `Hint ${number} of ${of}`,
  open: (number: number, of: number) => `Show hint ${number} of ${of}`,
};

export const solutionWords = {
  show: "Show a solution",
  warning:
    "You learn most by getting there yourself, and each hint tells more than the one before. Once you have seen a solution you cannot unsee it.",
  showAnyway: "Show it all the same",
  title: "A solution",
  lead: "One way to do it, with your program beside it. The lines in which they differ are marked.",
  same: "This is the solution, and your program is the same, line for line.",
  mine: "Your program",
  theirs: "The solution",
  take: "Put it into the editor",
  close: "Close",
  taken: "The solution is in the editor.",
  undo: "Undo",
  undone: "Your own program is back.",
};
