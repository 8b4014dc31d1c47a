/** What a mark reports of a project's runs: read with care, drawn cell by cell. */
import { expect, test } from "@playwright/test";
import { runsOf, wrongCells } from "../../site/src/page/result-map.ts";
import { readResults } from "../../site/src/runtime/results.ts";

const FIGURE = {
  ...{ name: "known", value: 87.25, unit: "%", digits: 1 },
  ...{ at_least: 85, at_most: null, met: true },
};
const MAP = { across: 3, cell_cm: 50, cells: "..?#!?x#." };
const RESULT = {
  ...{ check: 0, seed: 1, job: "run-1", why: "nothing left", points: 70, passed: true },
  world: { name: "room", title: "A room", obstacles: [], start: { x: 0, y: 0, heading: 0 } },
  figures: [FIGURE],
  map: MAP,
  path: [[100, 40]],
};

test("results are read as they are", () => {
  const bare = { ...RESULT, map: null, path: [], points: null, figures: [] };
  expect(readResults([RESULT, bare])).toEqual([RESULT, bare]);
});

for (const [what, result] of [
  ["a map that is not square", { ...RESULT, map: { ...MAP, cells: "..?" } }],
  ["cells of no size", { ...RESULT, map: { ...MAP, cell_cm: 0 } }],
  ["a figure that is no number", { ...RESULT, figures: [{ ...FIGURE, value: "87" }] }],
  ["digits without end", { ...RESULT, figures: [{ ...FIGURE, digits: 400 }] }],
  ["a reason without end", { ...RESULT, why: "x".repeat(3000) }],
  ["a place that is none", { ...RESULT, path: [[100]] }],
  ["a world that is none", { ...RESULT, world: "room" }],
] as const) {
  test(`a result with ${what} is refused`, () => {
    expect(() => readResults([RESULT, result])).toThrow("result 2 of the mark can't be read");
  });
}

test("cells side by side are drawn as one rectangle, from the bottom up", () => {
  // Free: two at the bottom left, one at the top right; y runs down in a picture of 200.
  expect(runsOf(MAP, ".")).toBe("M0 150h100v50h-100zM100 50h50v50h-50z");
  expect(runsOf(MAP, "#!")).toBe("M0 100h100v50h-100zM50 50h50v50h-50z");
  expect(wrongCells(MAP)).toEqual([
    [1, 1],
    [0, 2],
  ]);
  expect(wrongCells(null)).toEqual([]);
});
