import { expect, test } from "@playwright/test";
import { crosses, Evidence } from "../../site/src/trace/evidence.ts";
import type { Cell } from "../../site/src/trace/frames.ts";
import { grow, traceOf } from "./traces.ts";

/** The cell from (10, 20) to (15, 25), whose upper and right edges are its neighbours'. */
const CELL: Cell = { x: 10, y: 20, size: 5 };

/** A scan at a time, from a point, up the mat: one beam with that reading. */
const up = (t: number, x: number, y: number, reading: number) => ["scan", t, x, y, 0, [0, reading]];

/** How many passed, ended, and ended too close behind. */
function counts(rows: unknown[][], cell: Cell = CELL, t = 10) {
  const { passed, ended, close } = new Evidence(traceOf(rows)).of(cell, t);
  return [passed, ended, close];
}

test("a beam that goes through has passed, one that stops inside has ended", () => {
  expect(counts([up(0, 12, 0, 100)])).toEqual([1, 0, 0]);
  expect(counts([up(0, 12, 0, 22)])).toEqual([0, 1, 0]);
});

test("a beam that stops before, or runs beside, says nothing", () => {
  expect(counts([up(0, 12, 0, 19)])).toEqual([0, 0, 0]);
  expect(counts([up(0, 16, 0, 100)])).toEqual([0, 0, 0]);
  expect(counts([up(0, 12, 30, 100)])).toEqual([0, 0, 0]);
});

test("a beam along an edge belongs to the cell that holds the edge", () => {
  expect(counts([up(0, 10, 0, 100)])).toEqual([1, 0, 0]);
  expect(counts([up(0, 15, 0, 100)])).toEqual([0, 0, 0]);
  expect(counts([up(0, 15, 0, 100)], { ...CELL, x: 15 })).toEqual([1, 0, 0]);
});

test("a beam that ends on an edge ends in the cell that holds the edge", () => {
  expect(counts([up(0, 12, 0, 20)])).toEqual([0, 1, 0]);
  expect(counts([up(0, 12, 0, 25)])).toEqual([0, 0, 1]);
  expect(counts([up(0, 12, 0, 25)], { ...CELL, y: 25 })).toEqual([0, 1, 0]);
});

test("a beam passes a cell that one of its steps lies in: 2.5 cm each, up to 5 cm before its end", () => {
  // The last step before 22.4 cm is at 17.5 cm, the last before 22.5 cm at 20 cm.
  expect(counts([up(0, 12, 0, 27.4)])).toEqual([0, 0, 1]);
  expect(counts([up(0, 12, 0, 27.5)])).toEqual([1, 0, 0]);
});

test("the same from the left", () => {
  const right = (reading: number) => ["scan", 0, 5, 22, 90, [0, reading]];
  expect(counts([right(9.99)])).toEqual([0, 1, 0]);
  expect(counts([right(10)])).toEqual([0, 0, 1]);
});

test("the cell the robot stands in is passed by its beams", () => {
  expect(counts([up(0, 12, 22, 100)])).toEqual([1, 0, 0]);
});

test("170 and more is no hit, and counts as free up to 170 only", () => {
  const at = (y: number): Cell => ({ x: 0, y, size: 5 });
  expect(counts([up(0, 2, 0, 169.9)], at(165))).toEqual([0, 1, 0]);
  expect(counts([up(0, 2, 0, 170)], at(170))).toEqual([0, 0, 0]);
  expect(counts([up(0, 2, 0, 170)], at(165))).toEqual([1, 0, 0]);
  expect(counts([up(0, 2, 0, 200)], at(165))).toEqual([1, 0, 0]);
  expect(counts([up(0, 2, 0, 200)], at(170))).toEqual([0, 0, 0]);
  expect(counts([up(0, 2, 0, 200)], at(175))).toEqual([0, 0, 0]);
});

test("the beam's angle counts from the heading, clockwise", () => {
  const right: Cell = { x: 20, y: 0, size: 5 };
  expect(counts([["scan", 0, 1, 2, 60, [30, 21]]], right)).toEqual([0, 1, 0]);
  expect(counts([["scan", 0, 1, 2, 60, [-30, 21]]], right)).toEqual([0, 0, 0]);
});

test.describe("a segment and a cell, solved by hand", () => {
  const cases: [what: string, from: [number, number], by: [number, number], touches: boolean][] = [
    ["across", [0, 22], [30, 0], true],
    ["the other way across", [30, 22], [-30, 0], true],
    ["inside it", [11, 21], [1, 1], true],
    ["through the lower left corner, which is the cell's", [5, 25], [10, -10], true],
    ["the same, going up", [15, 15], [-10, 10], true],
    ["through the upper left corner, the neighbour's", [5, 20], [10, 10], false],
    ["through the lower right corner, the neighbour's", [10, 15], [10, 10], false],
    ["through the upper right corner, the neighbour's", [10, 30], [10, -10], false],
    ["past the upper right corner, inside", [10, 29.9], [10, -10], true],
    ["past the upper right corner, outside", [10, 30.1], [10, -10], false],
    ["down to the upper edge", [12, 30], [0, -5], false],
    ["down past the upper edge", [12, 30], [0, -5.1], true],
    ["up to the lower edge", [12, 15], [0, 5], true],
    ["left to the right edge", [20, 22], [-5, 0], false],
    ["from the right edge leftwards", [15, 22], [-1, 0], true],
    ["from the right edge rightwards", [15, 22], [1, 0], false],
    ["a point inside", [12, 22], [0, 0], true],
    ["a point on the upper edge", [12, 25], [0, 0], false],
    ["in its column and its row, but never in both", [9, 21.9], [1.1, -3], false],
    ["the same, a little less steep", [9, 21.9], [1.1, -2], true],
  ];
  for (const [what, [x, y], [dx, dy], touches] of cases) {
    test(what, () => expect(crosses(CELL, x, y, dx, dy)).toBe(touches));
  }
});

test("every point of a beam's way belongs to exactly one cell", () => {
  const rows = [["scan", 0, 3, 4, 0, [36.86989764584402, 50]]]; // (3, 4) to (33, 44)
  const touched: string[] = [];
  for (let x = 0; x < 50; x += 10) {
    for (let y = 0; y < 50; y += 10) {
      const [passed = 0, ended = 0, close = 0] = counts(rows, { x, y, size: 10 });
      if (passed + ended + close > 0) touched.push(`${x},${y}${ended ? " end" : ""}`);
    }
  }
  // x = 3 + 3k, y = 4 + 4k: y is a multiple of 10 at k = 1.5, 4, 6.5, 9; x at k = 2.33, 5.67, 9.
  expect(touched.sort()).toEqual(
    ["0,0", "0,10", "10,10", "10,20", "20,20", "20,30", "30,40 end"].sort(),
  );
});

test.describe("up to the shown time", () => {
  const rows = [up(1, 12, 0, 22), up(2, 12, 0, 100), up(3, 99, 0, 100), up(4, 13, 0, 24)];

  test("later beams do not count, and the last to touch is told", () => {
    const evidence = new Evidence(traceOf(rows));
    expect(evidence.of(CELL, 0.9)).toEqual({ passed: 0, ended: 0, close: 0, last: null });
    expect(evidence.of(CELL, 1)).toMatchObject({
      passed: 0,
      ended: 1,
      last: { t: 1, did: "ended" },
    });
    expect(evidence.of(CELL, 3)).toMatchObject({
      passed: 1,
      ended: 1,
      last: { t: 2, did: "passed" },
    });
    expect(evidence.of(CELL, 9)).toEqual({
      passed: 1,
      ended: 2,
      close: 0,
      last: { t: 4, x: 13, y: 0, endX: 13, endY: 24, reading: 24, did: "ended" },
    });
    expect(evidence.of({ ...CELL, x: 95 }, 9)).toMatchObject({ passed: 1, ended: 0 });
    expect(evidence.of(CELL, 1)).toMatchObject({ passed: 0, ended: 1 });
  });

  test("beams that come later are taken in", () => {
    const trace = traceOf(rows);
    const evidence = new Evidence(trace);
    evidence.of(CELL, 9);
    grow(trace, [up(5, 14, 0, 21)]);
    expect(evidence.of(CELL, 9)).toMatchObject({ passed: 1, ended: 3, last: { t: 5 } });
  });
});
