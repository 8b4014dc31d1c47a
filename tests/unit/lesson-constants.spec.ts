/** The build and the editor find the same numbers in a program, so a figure and its lab agree. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { parser } from "@lezer/python";
import { expect, test } from "@playwright/test";
import { filesBelow, ROOT } from "../../site/build/files.mjs";
import { constantsOf, withConstants } from "../../site/build/lessons/constants.mjs";
import { constantsOf as constantsOfEditor } from "../../site/src/editor/numbers.ts";

const LESSONS = join(ROOT, "lessons");

const ODD = `A = 1  # (0 to 2)
B: float = -.5  # cm (-1 to 1)
C, D = 1, 2
E = F = 3
G = 1e3
H = "5"
def f():
    I = 1
J = 2 + 3
`;

test("the numbers of every program of the lessons, and of an odd one", () => {
  const paths = filesBelow(LESSONS, (path) => path.endsWith(".py"));
  const programs = [ODD, ...paths.map((path) => readFileSync(join(LESSONS, path), "utf8"))];
  for (const program of programs) {
    const theirs = constantsOfEditor(parser.parse(program), program);
    const first = theirs.filter(({ name }, i) => theirs.findIndex((c) => c.name === name) === i);
    const wanted = first.map(({ name, from, to, value, ranged, low, high }) => [
      name,
      { from, to, value, ...(ranged ? { low, high } : { low: -Infinity, high: Infinity }) },
    ]);
    expect(Object.fromEntries(constantsOf(program))).toEqual(Object.fromEntries(wanted));
  }
});

test("another value goes in place of the number and of nothing else", () => {
  expect(withConstants(ODD, { A: "-2", B: "0.25" })).toBe(
    ODD.replace("A = 1", "A = -2").replace("-.5", "0.25"),
  );
  expect(() => withConstants(ODD, { C: "1" })).toThrow("the program has no line C = number");
});
