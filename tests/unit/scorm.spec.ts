/** What a lesson tells a learning platform, and how it finds one. */
import { expect, test } from "@playwright/test";
import type { ProgressRecord, TaskRecord } from "../../site/src/page/progress-record.ts";
import { ProgramStore } from "../../site/src/page/storage.ts";
import { findApi, Session, sessionTime } from "../../site/src/scorm/scorm-api.ts";
import { MOST_CHARACTERS, readSuspended, writeSuspended } from "../../site/src/scorm/scorm-data.ts";
import { reportOf } from "../../site/src/scorm/scorm-report.ts";

const LESSON = { lesson: "one", tasks: { add: {}, walk: {}, more: { stretch: true } } };

function progress(states: Record<string, TaskRecord["state"]>): ProgressRecord {
  const tasks = Object.entries(states).map(
    ([key, state]) => [key, { state, hints: 0, solution: false, at: 1 }] as const,
  );
  return { tasks: new Map(tasks), last: null };
}

function told(states: Record<string, TaskRecord["state"]>, before = "", readToEnd = false) {
  const report = reportOf(LESSON, progress(states), before, readToEnd);
  return [report["cmi.core.lesson_status"], report["cmi.core.score.raw"]];
}

test("the score is the share of the tasks for everybody; with all of them the lesson is passed", () => {
  expect(told({})).toEqual(["incomplete", "0"]);
  expect(told({ "one/add": "tried", "two/add": "passed", "one/more": "passed" })).toEqual([
    "incomplete",
    "0",
  ]);
  expect(told({ "one/add": "passed" }, "", true)).toEqual(["incomplete", "50"]);
  expect(told({ "one/add": "passed", "one/walk": "passed" })).toEqual(["passed", "100"]);
  expect(told({}, "passed")).toEqual(["passed", "0"]);
});

test("a lesson without tasks is completed when it has been read", () => {
  const article = { lesson: "one", tasks: {} };
  const report = (read: boolean) => reportOf(article, progress({}), "", read);
  expect(report(false)["cmi.core.lesson_status"]).toBe("incomplete");
  expect(report(true)["cmi.core.lesson_status"]).toBe("completed");
  expect(report(true)["cmi.core.score.raw"]).toBeUndefined();
});

test("what is kept is of this lesson, comes back as it was, and fits into the standard's room", () => {
  const kept = reportOf(LESSON, progress({ "one/add": "passed", "two/add": "tried" }), "", false);
  const text = kept["cmi.suspend_data"] ?? "";
  expect([...recordIn(text)]).toEqual([
    ["one/add", { state: "passed", hints: 0, solution: false, at: 1 }],
  ]);
});

/** The tasks in a platform's text. */
function recordIn(text: string): ProgressRecord["tasks"] {
  const read = readSuspended(text);
  if (typeof read === "string") throw new Error(`${read}: ${text}`);
  return read.record.tasks;
}

/** A lesson's progress of so many tasks, with all that can be known of each. */
function long(count: number, name = (n: number): string => `task-${n}`): ProgressRecord {
  const at = Date.UTC(2026, 10, 27);
  const tasks = Array.from({ length: count }, (_, n): [string, TaskRecord] => [
    `one/${name(n)}`,
    {
      ...{ state: n % 3 ? "passed" : "tried", hints: n % 4, solution: n % 2 === 0, at: at + n },
      ...(n % 5 ? {} : { score: { best: 80.5, bestAt: at, last: 3, lastAt: at + n, of: 100 } }),
      ...(n % 10 ? {} : { others: [{ best: 1, bestAt: at, last: 1, lastAt: at, of: 5 }] }),
    },
  ]);
  return { tasks: new Map(tasks), last: null };
}

test("what does not fit is packed tighter, and comes back as it was", () => {
  for (const count of [1, 30, 45, 60, 90]) {
    const progress = long(count);
    const text = writeSuspended("one", progress);
    expect(text.length, String(count)).toBeLessThanOrEqual(MOST_CHARACTERS);
    expect(recordIn(text), String(count)).toEqual(progress.tasks);
  }
});

test("what does not fit even so is short of details, of tries, and last of passes; it is never empty", () => {
  for (const [count, name] of [
    [300, (n: number) => `task-${n}`],
    [60, (n: number) => `${n}-${"a-long-name".repeat(8)}`],
    [5000, (n: number) => `${n}-${"a-long-name".repeat(8)}`],
  ] as const) {
    const progress = long(count, name);
    const text = writeSuspended("one", progress);
    expect(text.length).toBeLessThanOrEqual(MOST_CHARACTERS);
    const tasks = recordIn(text);
    const passed = [...tasks].filter(([, { state }]) => state === "passed");
    expect(passed.length).toBeGreaterThan(30);
    for (const [key] of passed) expect(progress.tasks.get(key)?.state).toBe("passed");
    if (passed.length < tasks.size) expect(passed.length).toBe(Math.floor((count / 3) * 2));
  }
});

test("what a newer version or somebody else has kept there is left alone", () => {
  for (const text of [
    "viewed=1|lastviewed=2",
    '{"format":"bugbot-progress","version":2}',
    '{"format":"bugbot-progress","version":1,"tasks":{"one/add":{"state":"go',
    "bugbot1 one;add,p,many,0,zz",
  ]) {
    expect(readSuspended(text), text).toBe("foreign");
  }
  expect(readSuspended(" ")).toBe("nothing");
  const report = reportOf(LESSON, progress({ "one/add": "passed" }), "", false, false);
  expect(report["cmi.suspend_data"]).toBeUndefined();
  expect(report["cmi.core.score.raw"]).toBe("50");
});

type Calls = Record<string, (...values: string[]) => unknown>;

/** A platform whose calls are these, and what it has been told. */
function platform(calls: Calls): { window: Window; told: string[] } {
  const told: string[] = [];
  const noted = Object.entries(calls).map(([name, call]) => [
    name,
    (...values: string[]) => {
      told.push([name, ...values].join(" "));
      return call(...values);
    },
  ]);
  const window: Record<string, unknown> = { API: Object.fromEntries(noted), opener: null };
  window.parent = window;
  return { window: window as unknown as Window, told };
}

const SOUND: Calls = {
  LMSInitialize: () => "true",
  LMSGetValue: (name) => (name === "cmi.core.student_id" ? "s-17" : ""),
  LMSSetValue: () => "true",
  LMSCommit: () => "true",
  LMSFinish: () => "true",
  LMSGetLastError: () => "0",
};

test("whatever call of a platform is missing, throws or refuses, the others are made to the end", () => {
  // What is in the way of a call is told in the console.
  console.info = () => {};
  const broken = [
    undefined,
    () => {
      throw new Error("the platform is out of order");
    },
    () => "false",
  ];
  for (const name of Object.keys(SOUND)) {
    for (const call of broken) {
      const { [name]: _, ...others } = SOUND;
      const { window, told } = platform({ ...others, ...(call ? { [name]: call } : {}) });
      const session = Session.begin(window, 0);
      expect(session?.get("cmi.suspend_data"), name).toBe("");
      session?.set({ "cmi.core.lesson_status": "passed" });
      session?.finish(1000);
      const ended = told.map((line) => line.split(" ")[0]);
      if (name !== "LMSFinish") expect(ended.at(-1), `without ${name}`).toBe("LMSFinish");
      if (name !== "LMSSetValue") {
        expect(told).toContain("LMSSetValue cmi.core.lesson_status passed");
      }
    }
  }
});

test("for a learner whom the platform does not name nothing is left on the device", () => {
  const items = new Map<string, string>();
  const device = { setItem: (key: string, text: string) => void items.set(key, text) };
  const store = new ProgramStore(() => device as unknown as Storage, "");
  expect(store.keep("progress", "passed")).toBe(false);
  expect(store.load("progress")).toBe("passed");
  expect(items.size).toBe(0);
});

test("time is written as the standard wants it", () => {
  expect([0, 3.456, 3725, 360_000].map(sessionTime)).toEqual([
    "0000:00:00.00",
    "0000:00:03.46",
    "0001:02:05.00",
    "0100:00:00.00",
  ]);
});

test("the platform is found in a frame around, in the opener's frames, or not at all", () => {
  const api = { LMSInitialize: () => "true" };
  /** @param parent null: the outermost */
  const frame = (parent: object | null, more: object = {}) => {
    const made: Record<string, unknown> = { opener: null, ...more };
    made.parent = parent ?? made;
    return made as unknown as Window;
  };
  const platform = frame(null, { API: api });
  expect(findApi(frame(frame(platform)))).toBe(api);
  expect(findApi(frame(null, { opener: frame(platform) }))).toBe(api);
  expect(findApi(frame(frame(null)))).toBeNull();
  const foreign = frame(platform);
  Object.defineProperty(foreign, "API", {
    get: () => {
      throw new Error("another origin");
    },
  });
  expect(findApi(frame(foreign))).toBe(api);
});
