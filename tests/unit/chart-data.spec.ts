import { expect, test } from "@playwright/test";
import {
  csvOf,
  joined,
  linesOf,
  MOST_LINES,
  short,
  shownNames,
  tableOf,
  valueAt,
} from "../../site/src/views/chart-data.ts";
import { traceOf } from "./traces.ts";

const plots = (...points: [t: number, name: string, value: number][]) =>
  traceOf(points.map((point) => ["plot", ...point]));

const ab = () => plots([0, "a", 1], [1, "a", 2], [1, "b", 5], [2, "a", 3], [3, "b", 6]);

test("lines of different times are joined on one axis, with nothing made up", () => {
  const [times, ...columns] = joined(linesOf(ab(), null, []));
  expect([...times]).toEqual([0, 1, 2, 3]);
  expect(columns).toEqual([
    [1, 2, 3, undefined],
    [undefined, 5, undefined, 6],
  ]);
});

test("of two values at one time the last counts", () => {
  const [, column] = joined(linesOf(plots([1, "a", 1], [1, "a", 2]), null, []));
  expect(column).toEqual([2]);
});

test("the run before lies behind this one, name by name", () => {
  const lines = linesOf(ab(), plots([0, "b", 9], [0, "c", 9]), []);
  expect(lines.map(({ name, role }) => `${name} ${role}`)).toEqual(["a run", "b earlier", "b run"]);
});

test("many runs give the lowest, the median and the highest, each value held until the next", () => {
  const runs = [
    plots([0, "a", 1], [2, "a", 4]),
    plots([0, "a", 3], [1, "a", 5]),
    plots([0, "a", 8]),
  ];
  const lines = Object.fromEntries(
    linesOf(plots([0, "a", 0]), null, runs).map(({ role, value }) => [role, Array.from(value)]),
  );
  expect(lines).toEqual({ low: [1, 1, 4], median: [3, 5, 5], high: [8, 8, 8], run: [0] });
  const even = linesOf(plots([0, "a", 0]), null, runs.slice(0, 2));
  expect(even.find(({ role }) => role === "median")?.value).toEqual([2, 3, 4.5]);
});

test("the value at a time is what was plotted last by then", () => {
  const series = ab().series.get("b");
  if (!series) throw new Error("b was plotted");
  expect([0.9, 1, 2.9, 3, 99].map((t) => valueAt(series, t))).toEqual([null, 5, 5, 6, 6]);
});

test("no more lines are drawn than can be told apart", () => {
  const many = plots(
    ...Array.from({ length: 40 }, (_, i): [number, string, number] => [i, `l${i}`, i]),
  );
  expect(shownNames(many, [])).toHaveLength(MOST_LINES);
  expect(linesOf(many, null, [])).toHaveLength(MOST_LINES);
});

test("the table keeps the first and the last time, and says how many there are", () => {
  const long = plots(
    ...Array.from({ length: 101 }, (_, i): [number, string, number] => [i, "a", i]),
  );
  const table = tableOf(long, 11);
  expect(table.rows.map(({ t }) => t)).toEqual([0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100]);
  expect(table.all).toBe(101);
  expect(tableOf(ab(), 60)).toEqual({
    names: ["a", "b"],
    rows: [
      { t: 0, values: [1, null] },
      { t: 1, values: [2, 5] },
      { t: 2, values: [3, 5] },
      { t: 3, values: [3, 6] },
    ],
    all: 4,
  });
  expect(tableOf(plots(), 60)).toEqual({ names: [], rows: [], all: 0 });
});

test("CSV has every value, and quotes names that need it", () => {
  expect(csvOf(ab())).toBe("time [s],a,b\r\n0,1,\r\n1,2,5\r\n2,3,\r\n3,,6\r\n");
  expect(csvOf(plots([0, 'say "hi", now', 1]))).toBe('time [s],"say ""hi"", now"\r\n0,1\r\n');
  expect(csvOf(plots())).toBe("time [s]\r\n");
});

test("numbers are short but true", () => {
  expect([64.1234, -0.4, 0.85, 1234.5, 12345678, 1e-5, 0].map(short)).toEqual([
    "64.12",
    "-0.4",
    "0.85",
    "1235",
    "1.235e+7",
    "0.00001",
    "0",
  ]);
});
