/** A program with many seeds: what is reported, and what ends the series early. */
import { expect, test } from "@playwright/test";
import { Repeat, TIMES } from "../../site/src/page/repeat.ts";
import type { Trace } from "../../site/src/trace/trace.ts";
import { traceOf, WORLD } from "./traces.ts";

const REQUEST = { program: "", world: WORLD, seed: 7 };

/** A run of a seed: it plots its own seed, and ends in the given way. */
function runOf(seed: number, status: "finished" | "limit" = "finished"): Trace {
  const trace = traceOf([
    ["plot", 0, "score", 0],
    ["plot", 1, "score", seed],
    ["end", 1, status, status === "limit" ? "Too long." : ""],
  ]);
  Object.assign(trace.header, { seed });
  return trace;
}

/** A series over runs that end as soon as they are asked for; `ending` tells how. */
function series(ending: (seed: number) => "finished" | "limit" = () => "finished") {
  const shown: string[] = [];
  const spares: number[] = [];
  const runtime = {
    run: ({ seed }: { seed: number }) => {
      const trace = runOf(seed, ending(seed));
      return { trace, done: Promise.resolve(trace), stop: () => {} };
    },
    expect: (count: number) => spares.push(count),
  };
  const repeat = new Repeat(runtime, {
    onFirst: ({ header }) => shown.push(`first ${header.seed}`),
    onFailed: ({ header }) => shown.push(`failed ${header.seed}`),
  });
  return { repeat, shown, spares };
}

test("twenty seeds, the asked one first, a line for each, and what they come to", async () => {
  const { repeat, shown, spares } = series();
  await repeat.start(REQUEST);
  const lines = repeat.report.split("\n");
  expect(repeat.runs.map(({ header }) => header.seed)).toEqual(
    Array.from({ length: TIMES }, (_, i) => 7 + i),
  );
  expect(lines[0]).toBe("Seed 7 finished: score 7");
  expect(lines[19]).toBe("Seed 26 finished: score 26");
  expect(lines.slice(20)).toEqual(["20 runs end at:", "score: median 16.5, from 7 to 26"]);
  expect(shown).toEqual(["first 7"]);
  expect(repeat.progress).toBeNull();
  expect(spares).toEqual([2, 1]);
});

test("a run that does not finish ends the series, and is the one to show", async () => {
  const { repeat, shown } = series((seed) => (seed === 9 ? "limit" : "finished"));
  await repeat.start(REQUEST);
  expect(repeat.report).toBe(
    [
      "Seed 7 finished: score 7",
      "Seed 8 finished: score 8",
      "Seed 9: Too long.",
      "2 runs end at:",
      "score: median 7.5, from 7 to 8",
    ].join("\n"),
  );
  expect(shown).toEqual(["first 7", "failed 9"]);
});

test("cancelled, it keeps the runs it has and starts no more", async () => {
  const { repeat } = series();
  repeat.addEventListener("change", () => {
    if (repeat.progress?.done === 3) repeat.cancel();
  });
  await repeat.start(REQUEST);
  expect(repeat.runs).toHaveLength(3);
  expect(repeat.report).toContain("3 runs end at:\nscore: median 8, from 7 to 9");
});

test("the seed after the largest is 0", async () => {
  const { repeat } = series();
  await repeat.start({ ...REQUEST, seed: 999_999 });
  expect(repeat.runs[1]?.header.seed).toBe(0);
});
