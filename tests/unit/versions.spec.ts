/** The list of earlier versions, and where two programs differ. */
import { expect, test } from "@playwright/test";
import {
  changeFrom,
  MOST_CHARACTERS,
  MOST_VERSIONS,
  readVersions,
  type Version,
  withVersion,
} from "../../site/src/page/versions.ts";

const times = (list: readonly Version[]) => list.map(({ at }) => at);

function after(texts: readonly string[]): Version[] {
  return texts.reduce((list: Version[], text, at) => withVersion(list, { at, text }), []);
}

test("the newest comes first, and a text is there once, at its latest time", () => {
  const list = after(["a", "b", "a", "c"]);
  expect(list.map(({ text }) => text)).toEqual(["c", "a", "b"]);
  expect(times(list)).toEqual([3, 2, 1]);
});

test("the oldest go when there are too many", () => {
  const list = after(Array.from({ length: MOST_VERSIONS + 5 }, (_, i) => `text ${i}`));
  expect(list).toHaveLength(MOST_VERSIONS);
  expect(times(list).at(-1)).toBe(5);
});

test("the oldest go when they are too long together, up to the last that fits exactly", () => {
  const quarter = MOST_CHARACTERS / 4;
  const long = (sign: string, length = quarter) => sign.repeat(length);
  expect(times(after([long("a"), long("b"), long("c"), long("d")]))).toEqual([3, 2, 1, 0]);
  expect(times(after([long("a"), long("b"), long("c"), long("d"), "e"]))).toEqual([4, 3, 2, 1]);
});

test("one that is too long alone is kept, alone", () => {
  expect(times(after(["a", "b", "c".repeat(MOST_CHARACTERS + 1)]))).toEqual([2]);
});

test("what is stored is read with care", () => {
  const list = after(["a", "b"]);
  expect(readVersions(JSON.stringify(list))).toEqual(list);
  expect(readVersions(null)).toEqual([]);
  expect(readVersions("{")).toEqual([]);
  expect(readVersions('{"at": 1}')).toEqual([]);
  const odd = [null, 1, {}, { at: "1", text: "a" }, { at: 1, text: 2 }, { at: 7, text: "good" }];
  expect(times(readVersions(JSON.stringify(odd)))).toEqual([7]);
});

test("a change is from its first line to its last", () => {
  expect(changeFrom("a\nb\nc", "a\nX\nc")).toEqual({ first: 2, last: 2 });
  expect(changeFrom("a\nb\nc", "X\nb\nY")).toEqual({ first: 1, last: 3 });
  expect(changeFrom("a\nb", "a\nb\nc\nd")).toEqual({ first: 3, last: 4 });
  expect(changeFrom("", "a")).toEqual({ first: 1, last: 1 });
  expect(changeFrom("a", "a")).toBeNull();
});

test("where lines are only gone the change has a place and no lines", () => {
  expect(changeFrom("a\nb\nc", "a\nc")).toEqual({ first: 2, last: 1 });
  expect(changeFrom("a\na\na", "a\na")).toEqual({ first: 3, last: 2 });
});
