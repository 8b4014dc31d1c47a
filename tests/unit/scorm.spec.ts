/** What a lesson tells a learning platform, and how it finds one. */
import { expect, test } from "@playwright/test";
import type { ProgressRecord, TaskRecord } from "../../site/src/page/progress-record.ts";
import { findApi, sessionTime } from "../../site/src/scorm/scorm-api.ts";
import { recordIn, reportOf } from "../../site/src/scorm/scorm-report.ts";

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
  expect([...recordIn(text).tasks]).toEqual([
    ["one/add", { state: "passed", hints: 0, solution: false, at: 1 }],
  ]);
  expect(recordIn("viewed=1|lastviewed=2").tasks.size).toBe(0);

  const many = Object.fromEntries(
    Array.from({ length: 90 }, (_, n) => [`one/task-${n}`, n < 9 ? "passed" : "tried"] as const),
  );
  const short = reportOf(LESSON, progress(many), "", false)["cmi.suspend_data"] ?? "";
  expect(short.length).toBeLessThanOrEqual(4096);
  expect(recordIn(short).tasks.size).toBe(9);
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
