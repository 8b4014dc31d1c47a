/** Which lines of two programs differ. */
import { expect, test } from "@playwright/test";
import { lineDiff } from "../../site/src/page/line-diff.ts";

const text = (...lines: string[]): string => lines.join("\n");

test("equal texts differ nowhere", () => {
  expect(lineDiff("a\nb\n", "a\nb\n")).toEqual({ first: [], second: [] });
});

test("a changed line is marked on both sides, an added one on its own", () => {
  const mine = text("def f(x):", "    return x", "");
  const theirs = text("def f(x):", "    y = x // 5", "    return y", "");
  expect(lineDiff(mine, theirs)).toEqual({ first: [2], second: [2, 3] });
});

test("lines that both have between two changes are not marked", () => {
  const mine = text("a", "x", "b", "c", "y", "d");
  const theirs = text("a", "1", "b", "c", "2", "3", "d");
  expect(lineDiff(mine, theirs)).toEqual({ first: [2, 5], second: [2, 5, 6] });
});

test("a line that has moved is marked once on each side", () => {
  expect(lineDiff(text("a", "b", "c"), text("b", "c", "a"))).toEqual({ first: [1], second: [3] });
});

test("an empty text has one line, which is not in the other", () => {
  expect(lineDiff("", "a\nb")).toEqual({ first: [1], second: [1, 2] });
});

test("where there is too much to compare, everything between the first and last counts", () => {
  const many = (sign: string): string =>
    text("same", ...Array.from({ length: 3000 }, (_, i) => `${sign}${i}`), "end");
  const { first, second } = lineDiff(many("a"), many("b"));
  expect([first.length, first[0], first.at(-1)]).toEqual([3000, 2, 3001]);
  expect(second.length).toBe(3000);
});
