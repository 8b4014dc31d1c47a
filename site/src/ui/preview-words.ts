/** The words of the authors' page, which only the development server has. Imports nothing of ours. */

const counted = (count: number, one: string, many = `${one}s`): string =>
  `${count} ${count === 1 ? one : many}`;

const list = new Intl.ListFormat("en-GB");

export const previewWords = {
  over: (code: string) => (code ? `${code} · for authors` : "For authors"),
  title: (title: string) => `What learners are told in “${title}”`,
  lead: "Each program of each task, marked by Python on this machine as a learner’s would be. Save a file, and what depends on it is marked again.",
  lessonPage: "The lesson’s page",
  lessons: "Lessons",
  overview: "Tasks",
  noTasks: "This lesson has no tasks.",
  trouble: "This lesson can’t be read.",

  markAll: "Mark everything",
  markTask: "Mark this task",
  markOne: "Mark",
  again: "Mark again",
  cancel: "Cancel",
  markOf: (file: string) => `Mark ${file}`,
  progress: (done: number, of: number) => `${done} of ${counted(of, "program")} marked`,
  allMarked: "All programs are marked.",
  waiting: (count: number) => `${counted(count, "program")} not marked yet.`,
  failed: "Marking stopped",

  columns: { task: "Task", causes: "Causes held", mutants: "Mutants" },
  kinds: { starter: "Starter", solution: "Solution", right: "Right", wrong: "Wrong" },
  groups: {
    starter: "Starter",
    solution: "Solution",
    right: "Right, in other styles",
    wrong: "Wrong attempts",
  },
  groupNotes: {
    starter: "It should fail, and name no mistake: nobody has made one yet.",
    solution: "It should pass.",
    right: "Each should pass.",
    wrong: "Each should fail and earn the words of its first line.",
  },
  none: {
    right: "None yet: a folder right/ holds them.",
    wrong: "None yet: a folder wrong/ holds them.",
  },
  good: (good: number, of: number) => `${good} of ${of}`,
  unmarked: "not marked",
  nothing: "none",
  notTried: "not tried",

  verdicts: {
    unmarked: "Not marked yet",
    marking: "Being marked …",
    trouble: "Could not be marked",
    fails: "Fails, as it should",
    passes: "Passes",
    earns: "Earns its words",
    "told by chance": "Names a mistake by chance",
    "should fail": "Passes, but should fail",
    "should pass": "Fails, but should pass",
    "earns other words": "Earns other words",
  },
  short: {
    unmarked: "not marked",
    marking: "being marked",
    trouble: "no mark",
    fails: "fails",
    passes: "passes",
    earns: "earns",
    "told by chance": "told by chance",
    "should fail": "passes",
    "should pass": "fails",
    "earns other words": "other words",
  },
  openCount: (count: number) => (count === 0 ? "none open" : `${count} open`),
  seconds: (seconds: number) => `${seconds.toFixed(1)} s`,
  style: "Style",
  shouldEarn: "Should earn",
  earns: "Earns",
  earnsNothing: (got: string) => `no cause; the words are looked for in what it got: ${got}`,
  given: "The given code is put round it when it is marked.",
  program: "Program",
  reads: "What the learner reads",
  notYet: "Mark it to see what a learner would read.",
  pointsAt: (number: number) => `The check points at hint ${number}`,

  statement: "The task’s words and hints",
  hint: (number: number) => `Hint ${number}`,

  causes: "Causes",
  causesNote: "What check.py can name as the cause, and the wrong attempt that shows it.",
  causesUnknown: "They are listed once a program of the task is marked.",
  noCauses: "check.py names none.",
  cause: "Cause",
  points: "Hint",
  heldBy: "Earned by",
  notHeld: "not held by a wrong attempt",
  gradersOwn: "the grader’s own",
  checkLine: (line: number) => `check.py, line ${line}`,

  mutants: "Mutants",
  mutantsNote:
    "The solution with one small change at a time. Each should fail, or have its reason in equivalent.json.",
  tryMutants: "Try the mutants",
  tryAgain: "Try them again",
  trying: "Trying …",
  tried: (done: number, of: number) => `${done} of ${of} tried`,
  killed: "fail",
  explained: "explained",
  open: "open",
  countOf: (count: number) => counted(count, "mutant"),
  opened: (count: number) =>
    count === 0
      ? "None is open."
      : `${counted(count, "mutant")} still ${count === 1 ? "passes" : "pass"}: add the case that tells ${count === 1 ? "it" : "them"} apart, or give a reason.`,
  line: (line: number) => `line ${line}`,
  reasons: (count: number) => `${counted(count, "reason")} in equivalent.json`,
  anything: "anything",
  removed: "Before",
  added: "After",
  files: (files: readonly string[]) => list.format(files),
};
