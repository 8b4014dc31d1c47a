/** The dialogue of a marking, with interpreters made by hand: who is told what, and who is ended. */
import { expect, test } from "@playwright/test";
import { Marker, type MarkProgress } from "../../site/src/runtime/marker.ts";
import { readStep } from "../../site/src/runtime/marks.ts";
import type { FromWorker, ToWorker } from "../../site/src/runtime/messages.ts";
import type { Partner } from "../../site/src/runtime/pool.ts";

const WORLD = { name: "room", title: "A room", obstacles: [], start: { x: 0, y: 0, heading: 0 } };
const PASSED = {
  format: 1,
  lesson: "tiny",
  task: "cell-of",
  passed: true,
  checks: [
    {
      title: "All",
      status: "passed",
      expected: null,
      got: null,
      where: null,
      likely: null,
      hint: null,
    },
  ],
  results: [],
  score: null,
  ours: null,
};

const job = (id: string, limits: object = {}): string =>
  JSON.stringify({
    ...{ id, kind: "run", world: WORLD, seed: 4701, number: 1 },
    limits: { real_s: 60, silent_s: 10, ...limits },
  });
const jobs = (...texts: string[]): string => JSON.stringify({ jobs: texts });

/** What an interpreter answers; undefined for silence. */
type Script = (message: ToWorker) => FromWorker | readonly FromWorker[] | undefined;

/** An interpreter that answers by a script and keeps what it is told. */
class Hand implements Partner {
  readonly told: ToWorker[] = [];
  ended = false;
  readonly #script: Script;
  #listener: (message: FromWorker) => void = () => {};

  constructor(script: Script) {
    this.#script = script;
  }

  listen(listener: (message: FromWorker) => void): void {
    this.#listener = listener;
  }

  send(message: ToWorker): void {
    if (this.ended) throw new Error("an interpreter that is ended was spoken to");
    this.told.push(message);
    if (message.kind === "package" || message.kind === "stdlib") return;
    const answer =
      message.kind === "inspect"
        ? ({ kind: "imports", id: 0, missing: [], hasStdlib: true } as const)
        : this.#script(message);
    const answers = answer === undefined ? [] : Array.isArray(answer) ? answer : [answer];
    for (const one of answers) queueMicrotask(() => this.ended || this.#listener(one));
  }

  end(): void {
    this.ended = true;
  }
}

/** A marking in which the first interpreter is the judge, with these steps, and the rest perform. */
function marking(steps: readonly string[], perform: Script = done, oneAtATime = false) {
  const hands: Hand[] = [];
  const progress: MarkProgress[] = [];
  let next = 0;
  let spares = 0;
  let most = 0;
  const judge: Script = () => ({ kind: "step", id: 0, step: steps[next++] ?? "" });
  const marker = new Marker(
    {
      lesson: "tiny",
      task: "cell-of",
      check: "check",
      program: "program",
      starter: "starter",
      worlds: [],
    },
    { onProgress: (one) => progress.push(one) },
    {
      take: async () => {
        const hand = new Hand(hands.length === 0 ? judge : perform);
        hands.push(hand);
        most = Math.max(most, hands.filter(({ ended }) => !ended).length - 1);
        return hand;
      },
      prepare: async () => {
        spares += 1;
      },
      oneAtATime,
    },
    {
      stdlib: async () => new ArrayBuffer(8),
      numpy: () => Promise.reject(),
      judging: async () => new ArrayBuffer(8),
    },
  );
  return {
    ...{ marker, hands, progress, judge: () => hands[0] as Hand },
    /** The most performers at work at once, and how often a spare was asked for. */
    load: () => ({ most, spares }),
  };
}

const done: Script = (message) =>
  message.kind === "perform"
    ? { kind: "performed", id: 0, result: `{"of":${message.job}}` }
    : undefined;

test("what would tell a program what is right comes to the judge alone", async () => {
  const { marker, hands } = marking([jobs(job("a"), job("b")), JSON.stringify({ mark: PASSED })]);
  await marker.done;
  const given = hands.map(({ told }) => told.filter(({ kind }) => kind === "package").length);
  expect(given).toEqual([1, 0, 0]);
});

test("a small device has one performer at a time, and no spare beside it", async () => {
  const steps = [jobs(job("a"), job("b"), job("c")), JSON.stringify({ mark: PASSED })];
  const small = marking(steps, done, true);
  expect(await small.marker.done).toMatchObject({ kind: "marked" });
  expect(small.load()).toEqual({ most: 1, spares: 0 });
  const large = marking(steps, done);
  await large.marker.done;
  expect(large.load().most).toBe(2);
});

const settled = (): Promise<void> => new Promise((resolve) => setImmediate(resolve));

test("the judge hears every result in the order of its jobs, and each job has an interpreter", async () => {
  const { marker, hands, progress, judge } = marking([
    jobs(job("a"), job("b"), job("c")),
    jobs(job("d")),
    JSON.stringify({ mark: PASSED }),
  ]);
  const marked = await marker.done;
  expect(marked).toMatchObject({ kind: "marked", mark: { passed: true } });
  const results = judge().told.filter((message) => message.kind === "results");
  expect(results.map((message) => message.results)).toEqual([
    [job("a"), job("b"), job("c")].map((text) => `{"of":${text}}`),
    [`{"of":${job("d")}}`],
  ]);
  expect(hands).toHaveLength(5);
  for (const hand of hands) expect(hand.ended).toBe(true);
  expect(hands.flatMap(({ told }) => told).filter(({ kind }) => kind === "perform")).toHaveLength(
    4,
  );
  expect(judge().told.some(({ kind }) => kind === "perform")).toBe(false);
  expect(progress.at(0)).toEqual({ done: 0, of: 3, now: null });
  expect(progress.at(-1)).toEqual({ done: 4, of: 4, now: { mat: 1, mats: 1, seed: 1 } });
});

test("the program is told to the performers with the job's own text, and the check is not", async () => {
  const { marker, hands } = marking([jobs(job("a")), JSON.stringify({ mark: PASSED })]);
  await marker.done;
  expect(hands[1]?.told.at(-1)).toEqual({
    kind: "perform",
    id: 0,
    program: "program",
    job: job("a"),
  });
  expect(JSON.stringify(hands[1]?.told)).not.toContain("check");
});

test("an interpreter that breaks becomes a result", async () => {
  const broken: Script = () => ({
    ...{ kind: "died", id: 0, reason: "fatal", line: null, message: "null function" },
  });
  const { marker, judge } = marking([jobs(job("a")), JSON.stringify({ mark: PASSED })], broken);
  expect((await marker.done).kind).toBe("marked");
  const told = judge().told.at(-1);
  expect(told?.kind === "results" && JSON.parse(told.results[0] ?? "")).toMatchObject({
    ...{ id: "a", trace: null, answers: null, died: "crash" },
  });
});

test("a program that computes for ever is ended, and one whose time passes is not", async () => {
  const quick = { silent_s: 0.05 };
  const endless = marking(
    [jobs(job("a", quick)), JSON.stringify({ mark: PASSED })],
    () => undefined,
  );
  await endless.marker.done;
  const told = endless.judge().told.at(-1);
  expect(told?.kind === "results" && told.results[0]).toContain('"died":"time"');

  const alive = marking(
    [jobs(job("a", { silent_s: 30 })), JSON.stringify({ mark: PASSED })],
    (message) =>
      message.kind === "perform"
        ? [
            { kind: "beat", id: 0, t: 1 },
            { kind: "beat", id: 0, t: 2 },
            { kind: "performed", id: 0, result: "whole" },
          ]
        : undefined,
  );
  await alive.marker.done;
  const heard = alive.judge().told.at(-1);
  expect(heard?.kind === "results" && heard.results[0]).toBe("whole");
});

test("cancelled, everybody at work is ended and nobody new begins", async () => {
  const { marker, hands } = marking([jobs(job("a"), job("b"), job("c"))], () => undefined);
  await settled();
  await settled();
  expect(hands).toHaveLength(3);
  marker.cancel();
  expect(await marker.done).toEqual({ kind: "cancelled" });
  await settled();
  expect(hands).toHaveLength(3);
  for (const hand of hands) expect(hand.ended).toBe(true);
});

for (const [what, steps, perform, message] of [
  [
    "a judge that says what is no step",
    ['{"mark":{"passed":true}}'],
    done,
    "neither jobs nor a mark",
  ],
  ["a job that is none", ['{"jobs":["{}"]}'], done, "no job"],
  [
    "a check that asks for ever",
    Array.from({ length: 30 }, () => jobs(job("a"))),
    done,
    "gave no mark",
  ],
  [
    "a fault of ours in a performer",
    [jobs(job("a"))],
    (() => ({
      kind: "died",
      id: 0,
      reason: "internal",
      line: null,
      message: "KeyError: kind",
    })) as Script,
    "KeyError: kind",
  ],
  [
    "a performer that says a step",
    [jobs(job("a"))],
    (() => ({ kind: "step", id: 0, step: "" })) as Script,
    "was not asked for",
  ],
] as const) {
  test(`${what} ends the marking as a fault of ours`, async () => {
    const { marker, hands } = marking(steps, perform);
    const marked = await marker.done;
    expect(marked.kind).toBe("failed");
    expect(marked.kind === "failed" && marked.message).toContain(message);
    for (const hand of hands) expect(hand.ended).toBe(true);
  });
}

const where = { world: WORLD, cells: [[1, 2]], cell_cm: 5, seconds: null, job: null };
const failed = { ...PASSED.checks[0], status: "failed", where };

test("a mark is read as it is", () => {
  const mark = { ...PASSED, passed: false, checks: [failed] };
  expect(readStep(JSON.stringify({ mark }))).toEqual({ mark });
});

test("a mark with results that are no list, or a score that is none, is refused", () => {
  const score = { value: 61.5, of: 100, how: "what is known" };
  const good = { ...PASSED, results: [{ seed: 1 }], score };
  expect(readStep(JSON.stringify({ mark: good }))).toEqual({ mark: good });
  for (const bad of [{ results: "none" }, { results: [1] }, { score: { ...score, of: 0 } }]) {
    expect(() => readStep(JSON.stringify({ mark: { ...good, ...bad } }))).toThrow("neither jobs");
  }
});

for (const [what, check] of [
  ["a state there is not", { ...failed, status: "won" }],
  ["a hint that is no number", { ...failed, hint: "1" }],
  ["a cell that is no pair", { ...failed, where: { ...where, cells: [[1]] } }],
  ["cells of no size", { ...failed, where: { ...where, cell_cm: 0 } }],
  ["a text without end", { ...failed, got: "x".repeat(60_000) }],
  ["a world that is none", { ...failed, where: { ...where, world: "room" } }],
] as const) {
  test(`a mark with ${what} is refused`, () => {
    const mark = { ...PASSED, checks: [check] };
    expect(() => readStep(JSON.stringify({ mark }))).toThrow("neither jobs nor a mark");
  });
}
