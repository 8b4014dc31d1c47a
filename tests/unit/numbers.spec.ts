/** Which numbers of a program can be moved, by what steps, and how a new value is written. */
import { pythonLanguage } from "@codemirror/lang-python";
import { expect, test } from "@playwright/test";
import {
  type Constant,
  constantsOf,
  numberAt,
  onStep,
  stepped,
  type WrittenNumber,
  writtenLike,
} from "../../site/src/editor/numbers.ts";

const parse = (text: string) => pythonLanguage.parser.parse(text);
const constants = (text: string): Constant[] => constantsOf(parse(text), text);

/** The constant of a program of one line. */
function only(line: string): Constant {
  const [first] = constants(line);
  if (!first) throw new Error(`no constant in: ${line}`);
  return first;
}

/** The number at the place marked by | in a program, as it is written. */
function at(marked: string): WrittenNumber | null {
  const place = marked.indexOf("|");
  const text = marked.replace("|", "");
  return numberAt(parse(text), text, place);
}

test("constants of every kind, with their ranges", () => {
  const text = `
CELL = 5  # cm per cell (5 to 20)
L_OCC = 0.85  # added to the cell a beam ended in (0 to 2)
L_FREE = -0.4  # per half-cell step (-1 to 0)
SPEED: int = 50  # per cent (10 to 100)
MAT = 200  # side of the mat [cm]
`;
  expect(constants(text)).toMatchObject([
    { name: "CELL", value: 5, low: 5, high: 20, step: 1, ranged: true },
    { name: "L_OCC", value: 0.85, low: 0, high: 2, step: 0.02, ranged: true },
    { name: "L_FREE", value: -0.4, low: -1, high: 0, step: 0.01, ranged: true, text: "-0.4" },
    { name: "SPEED", value: 50, low: 10, high: 100, step: 1, ranged: true },
    { name: "MAT", value: 200, step: 1, ranged: false },
  ]);
});

for (const line of [
  "# CELL = 5  # (1 to 9)",
  "'''\nCELL = 5  # (1 to 9)\n'''",
  "def f():\n    CELL = 5  # (1 to 9)",
  "if True:\n    CELL = 5  # (1 to 9)",
  "A = B = 5  # (1 to 9)",
  "A, B = 5, 6  # (1 to 9)",
  "A = 5 + 1  # (1 to 9)",
  "A = '5'  # (1 to 9)",
  "a.b = 5  # (1 to 9)",
  "A += 5  # (1 to 9)",
  "A = 0x1f  # (1 to 99)",
  "A = 1e3  # (1 to 9999)",
  "A = 3j  # (1 to 9)",
  "f(A=5)  # (1 to 9)",
]) {
  test(`no constant: ${JSON.stringify(line)}`, () => {
    expect(constants(line)).toEqual([]);
  });
}

for (const comment of ["", "# (9 to 1)", "# (5 to 5)", "# 1 to 9", "# (a to b)", "\n# (1 to 9)"]) {
  test(`a constant without a range: ${JSON.stringify(comment)}`, () => {
    expect(only(`A = 5  ${comment}`).ranged).toBe(false);
  });
}

test("steps: 1 for whole numbers, else about a hundredth of the range in round figures", () => {
  const step = (line: string): number => only(line).step;
  expect(step("A = 5  # (1 to 1000)")).toBe(1);
  expect(step("A = 1  # (0.5 to 5)")).toBe(0.05);
  expect(step("A = 0.65  # (0.5 to 0.99)")).toBe(0.005);
  expect(step("A = 2.5  # (0 to 10)")).toBe(0.1);
  expect(step("A = 0.5  # (0 to 3)")).toBe(0.02);
  expect(step("A = 0.001  # (0 to 0.002)")).toBe(0.00002);
});

test("a slider's value lands on the steps, inside the range", () => {
  const cell = only("CELL = 5  # (5 to 20)");
  expect(onStep(cell, 7.4)).toBe(7);
  expect(onStep(cell, 99)).toBe(20);
  const occ = only("L_OCC = 0.85  # (0 to 2)");
  expect(onStep(occ, 0.3000001)).toBe(0.3);
});

test("a key goes to the next step, from between two steps as well", () => {
  const occ = only("L_OCC = 0.85  # (0 to 2)");
  expect(stepped(occ, 1)).toBe(0.86);
  expect(stepped(occ, -1)).toBe(0.84);
  const free = only("L_FREE = -0.4  # (-1 to 0)");
  expect(stepped(free, 1)).toBe(-0.39);
  expect(stepped({ ...free, value: 0 }, 1)).toBe(0);
});

test("any number can be moved, by its own last decimal", () => {
  expect(at("turn(9|0)")).toMatchObject({ text: "90", step: 1 });
  expect(at("turn(|90)")).toMatchObject({ text: "90" });
  expect(at("wait(0.25|)")).toMatchObject({ text: "0.25", step: 0.01 });
  expect(at("turn(-|90)")).toMatchObject({ text: "-90" });
  expect(at("turn(|-90)")).toMatchObject({ text: "-90" });
  expect(at("x = a -|5")).toMatchObject({ text: "5" });
  expect(at("CELL = |5  # (5 to 20)")).toMatchObject({ low: 5, high: 20 });
});

for (const none of ['"a 5| b"', "# 5| cm", "x5| = y", "0x1|f", "a|", "x = -|a"]) {
  test(`no number to move at ${none}`, () => {
    expect(at(none)).toBeNull();
  });
}

test("a value is written as the one before it was", () => {
  expect(writtenLike("5", 6)).toBe("6");
  expect(writtenLike("0.85", 0.9)).toBe("0.90");
  expect(writtenLike("-0.4", -0.39)).toBe("-0.39");
  expect(writtenLike("1", 1.05)).toBe("1.05");
  expect(writtenLike("1.0", 2)).toBe("2.0");
  expect(writtenLike("5.", 6)).toBe("6.0");
  expect(writtenLike("0.30", 0.1 + 0.2)).toBe("0.30");
  expect(writtenLike("-0.1", -0)).toBe("0.0");
});
