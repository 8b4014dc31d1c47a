/** A learner's progress: kept, merged so that no pass is lost, and read with care. */
import { expect, test } from "@playwright/test";
import { Progress, ProgressError } from "../../site/src/page/progress.ts";
import { ProgramStore } from "../../site/src/page/storage.ts";

/** Local storage of a device, or one that refuses to keep anything. */
function device(refuses = false): Storage {
  const kept = new Map<string, string>();
  return {
    getItem: (name: string) => kept.get(name) ?? null,
    setItem: (name: string, text: string) => {
      if (refuses) throw new Error("full");
      kept.set(name, text);
    },
    removeItem: (name: string) => kept.delete(name),
  } as unknown as Storage;
}

function progressOn(storage: Storage, now = 1000): Progress {
  return new Progress(new ProgramStore(() => storage), () => now);
}

test("what happened is there again after a reload", () => {
  const storage = device();
  const before = progressOn(storage);
  before.visit("u8-1", "cell-of");
  before.hintsOpened("u8-1", "cell-of", 2);
  before.marked("u8-1", "cell-of", true);
  before.marked("u8-1", "centre", false);
  const after = progressOn(storage);
  expect(after.of("u8-1", "cell-of")).toEqual({
    ...{ state: "passed", hints: 2, solution: false, at: 1000 },
  });
  expect(after.count("u8-1", ["cell-of", "centre", "size"])).toEqual({
    passed: 1,
    tried: 1,
    of: 3,
  });
  expect(after.last).toEqual({ lesson: "u8-1", task: "cell-of" });
  expect(after.of("u8-1", "size")).toBeNull();
});

test("a pass stays a pass, with the day it came", () => {
  const storage = device();
  progressOn(storage, 1000).marked("u8-1", "cell-of", true);
  const later = progressOn(storage, 2000);
  later.marked("u8-1", "cell-of", false);
  later.marked("u8-1", "cell-of", true);
  later.solutionSeen("u8-1", "cell-of");
  expect(later.of("u8-1", "cell-of")).toEqual({
    ...{ state: "passed", hints: 0, solution: true, at: 1000 },
  });
});

test("what another tab has kept meanwhile is not written over", () => {
  const storage = device();
  const here = progressOn(storage);
  const there = progressOn(storage);
  there.marked("u8-1", "centre", true);
  here.marked("u8-1", "cell-of", true);
  expect(progressOn(storage).count("u8-1", ["cell-of", "centre"]).passed).toBe(2);
});

test("a file from another device is added, and nothing here is lost", () => {
  const home = progressOn(device());
  home.marked("u8-1", "cell-of", true);
  home.marked("u8-1", "centre", false);
  const school = progressOn(device());
  school.marked("u8-1", "cell-of", false);
  school.marked("u8-1", "size", true);
  expect(school.import(home.export())).toEqual({ added: 2 });
  const states = ["cell-of", "centre", "size"].map((task) => school.of("u8-1", task)?.state);
  expect(states).toEqual(["passed", "tried", "passed"]);
  expect(school.import(home.export())).toEqual({ added: 0 });
});

test("clearing forgets everything, and can be undone with what came since", () => {
  const storage = device();
  const progress = progressOn(storage);
  progress.marked("u8-1", "cell-of", true);
  const undo = progress.clear();
  expect(progress.empty).toBe(true);
  expect(progressOn(storage).empty).toBe(true);
  progress.marked("u8-1", "centre", true);
  undo();
  expect(progressOn(storage).count("u8-1", ["cell-of", "centre"]).passed).toBe(2);
});

const task = { state: "passed", hints: 0, solution: false, at: 1 };
const file = (parts: object): string =>
  JSON.stringify({ format: "bugbot-progress", version: 1, tasks: {}, last: null, ...parts });

for (const [what, text, message] of [
  ["no JSON", "passed!", /not a file of progress/],
  ["another kind of file", '{"format":"bugbot-trace"}', /not a file of progress/],
  ["a list", "[]", /not a file of progress/],
  ["a newer version", file({ version: 2 }), /newer version/],
  ["no tasks", file({ tasks: null }), /damaged/],
  ["a state there is not", file({ tasks: { "a/b": { ...task, state: "won" } } }), /damaged/],
  ["hints below none", file({ tasks: { "a/b": { ...task, hints: -1 } } }), /damaged/],
  ["a name that is none", file({ tasks: { "<b>/x": task } }), /damaged/],
  [
    "a name that is the prototype's",
    `${file({}).slice(0, -1)},"tasks":{"__proto__":{}}}`,
    /damaged/,
  ],
] as const) {
  test(`a file with ${what} is refused in words, and changes nothing`, () => {
    const progress = progressOn(device());
    progress.marked("u8-1", "cell-of", true);
    const before = progress.export();
    expect(() => progress.import(text)).toThrow(ProgressError);
    expect(() => progress.import(text)).toThrow(message);
    expect(progress.export()).toBe(before);
  });
}

test("what somebody else keeps under this name is no progress, and does no harm", () => {
  const storage = device();
  storage.setItem("bugbot:progress", "{broken");
  const progress = progressOn(storage);
  expect(progress.empty).toBe(true);
  progress.marked("u8-1", "cell-of", true);
  expect(progressOn(storage).of("u8-1", "cell-of")?.state).toBe("passed");
});

test("where the device refuses, progress lasts as long as the page and says so", () => {
  const progress = progressOn(device(true));
  expect(progress.kept).toBe(true);
  progress.marked("u8-1", "cell-of", true);
  expect(progress.kept).toBe(false);
  expect(progress.of("u8-1", "cell-of")?.state).toBe("passed");
});

test("the best score and the last are kept, and go along in a file", () => {
  const storage = device();
  progressOn(storage, 1000).scored("u8-7", "project", 60, 100);
  progressOn(storage, 2000).scored("u8-7", "project", 72.5, 100);
  const here = progressOn(storage, 3000);
  here.marked("u8-7", "project", true);
  here.scored("u8-7", "project", 65, 100);
  const kept = { best: 72.5, bestAt: 2000, last: 65, lastAt: 3000, of: 100 };
  expect(here.of("u8-7", "project")).toMatchObject({ state: "passed", score: kept });

  const school = progressOn(device(), 2500);
  school.scored("u8-7", "project", 71, 100);
  school.import(here.export());
  expect(school.of("u8-7", "project")?.score).toEqual(kept);
  // Where the points are counted anew, a score of before is no measure.
  here.scored("u8-7", "project", 7, 10);
  expect(here.of("u8-7", "project")?.score).toMatchObject({ best: 7, of: 10 });
});

test("a score that is none is left out of a file", () => {
  const text = JSON.stringify({
    ...{ format: "bugbot-progress", version: 1, last: null },
    tasks: { "a/b": { state: "tried", hints: 0, solution: false, at: 1, score: { best: "9" } } },
  });
  const progress = progressOn(device());
  progress.import(text);
  expect(progress.of("a", "b")).toEqual({ state: "tried", hints: 0, solution: false, at: 1 });
});

const FOREIGN = {
  newer: '{"format":"bugbot-progress","version":2,"done":["u8-1/cell-of"]}',
  "of somebody else": '{"format":"another program"}',
  "cut off": '{"format":"bugbot-progress","version":1,"tasks":{"u8-1/cell-of":{"state":"pass',
  "with a task that is none":
    '{"format":"bugbot-progress","version":1,"last":null,"tasks":{"u8-1/centre":{"state":"passed","hints":0,"solution":false,"at":1},"u8-1/size":{"state":"gold"}}}',
  "with a moment that is none":
    '{"format":"bugbot-progress","version":1,"last":null,"tasks":{"u8-1/size":{"state":"passed","hints":0,"solution":false,"at":1e300}}}',
};

for (const [what, text] of Object.entries(FOREIGN)) {
  test(`a record ${what} is never lost by going on`, () => {
    const storage = new Map<string, string>([["bugbot:progress", text]]);
    const device = {
      getItem: (name: string) => storage.get(name) ?? null,
      setItem: (name: string, value: string) => void storage.set(name, value),
      removeItem: (name: string) => void storage.delete(name),
    } as unknown as Storage;
    const progress = progressOn(device);
    expect(progress.unread.map((unread) => unread.text)).toEqual([text]);
    progress.visit("u8-1", "cell-of");
    progress.marked("u8-1", "cell-of", true);
    expect([...storage.values()]).toContain(text);
    const after = progressOn(device);
    expect(after.of("u8-1", "cell-of")?.state).toBe("passed");
    expect(after.unread.map((unread) => unread.text)).toEqual([text]);
    if (what === "newer") expect(storage.get("bugbot:progress")).toBe(text);
    if (text.includes("centre")) expect(after.of("u8-1", "centre")?.state).toBe("passed");
    // What was never told of can be cleared, and brought back.
    const undo = after.clear();
    expect(after.empty).toBe(true);
    undo();
    expect([...storage.values()]).toContain(text);
    expect(after.of("u8-1", "cell-of")?.state).toBe("passed");
  });
}

test("what was kept beside a newer record is taken in once that can be read", () => {
  const storage = device();
  storage.setItem("bugbot:progress", FOREIGN.newer);
  progressOn(storage).marked("u8-1", "cell-of", true);
  const other = progressOn(device());
  other.marked("u8-1", "centre", true);
  storage.setItem("bugbot:progress", other.export());
  const progress = progressOn(storage);
  progress.marked("u8-1", "size", false);
  expect(progressOn(storage).count("u8-1", ["cell-of", "centre", "size"]).passed).toBe(2);
  expect(storage.getItem("bugbot:progress:beside")).toBeNull();
});

test("a file of as many tasks as there may be does not cost what is here", () => {
  const many = (from: number, count: number): string => {
    const tasks = Object.fromEntries(
      Array.from({ length: count }, (_, n) => [
        `other/task-${from + n}`,
        { state: "passed", hints: 0, solution: false, at: 1 },
      ]),
    );
    return JSON.stringify({ format: "bugbot-progress", version: 1, tasks, last: null });
  };
  const storage = device();
  const progress = progressOn(storage);
  progress.marked("u8-1", "cell-of", true);
  expect(() => progress.import(many(0, 5000))).toThrow("more than 5,000 tasks");
  expect(progressOn(storage).of("u8-1", "cell-of")?.state).toBe("passed");
  progress.import(many(0, 4999));
  // One more of one's own: a device may hold more than a file.
  progress.marked("u8-1", "centre", true);
  expect(progressOn(storage).count("u8-1", ["cell-of", "centre"]).passed).toBe(2);
});

test("scores of another maximum are kept apart, and a moment that is none is refused", () => {
  const storage = device();
  const progress = progressOn(storage);
  progress.scored("u8-7", "project", 80, 100);
  const file = (score: object): string =>
    JSON.stringify({
      format: "bugbot-progress",
      version: 1,
      last: null,
      tasks: { "u8-7/project": { state: "tried", hints: 0, solution: false, at: 1, score } },
    });
  progress.import(file({ best: 1, bestAt: 900, last: 1, lastAt: 900, of: 5 }));
  const after = progressOn(storage).of("u8-7", "project");
  expect(after?.score).toMatchObject({ best: 80, of: 100 });
  expect(after?.others).toMatchObject([{ best: 1, of: 5 }]);
  // The task itself counts another way now: that is what counts, and what was reached is still there.
  progress.scored("u8-7", "project", 3, 5);
  expect(progress.of("u8-7", "project")?.score).toMatchObject({ best: 3, last: 3, of: 5 });
  expect(progress.of("u8-7", "project")?.others).toMatchObject([{ best: 80, of: 100 }]);
  expect(() => progress.import(file({}).replace('"at":1', '"at":1e300'))).toThrow("damaged");
  progress.import(file({ best: 99, bestAt: 1e300, last: 9, lastAt: 1, of: 100 }));
  expect(progress.of("u8-7", "project")?.others).toMatchObject([{ best: 80, of: 100 }]);
});
