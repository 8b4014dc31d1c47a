import { expect, test } from "@playwright/test";
import type { Print } from "../../site/src/trace/events.ts";
import {
  ConsoleLines,
  MOST_CHARACTERS,
  MOST_LINES,
  type PrintedLine,
} from "../../site/src/views/console-lines.ts";

const out = (text: string): Print => ({ t: 0, stream: "stdout", text });
const err = (text: string): Print => ({ t: 0, stream: "stderr", text });
const plain = (lines: PrintedLine[]) =>
  lines.map(({ number, pieces }) => `${number} ${pieces.map(({ text }) => text).join("|")}`);

test("prints become lines, wherever they were cut", () => {
  const lines = new ConsoleLines([out("a\nb"), out("c\n"), out("\n"), out("d")]);
  expect(plain(lines.after(4))).toEqual(["0 a", "1 b|c", "2 ", "3 d"]);
  expect(plain(lines.after(1))).toEqual(["0 a", "1 b"]);
  expect(lines.after(0)).toEqual([]);
});

test("a line that has just ended leaves no empty one after it", () => {
  expect(plain(new ConsoleLines([out("a\n")]).after(1))).toEqual(["0 a"]);
});

test("each piece keeps its stream", () => {
  const [line] = new ConsoleLines([out("x="), err("no\n")]).after(2);
  expect(line?.pieces).toEqual([
    { stream: "stdout", text: "x=" },
    { stream: "stderr", text: "no" },
  ]);
});

test("a note has a line to itself, wherever the print before it stopped", () => {
  const note = { t: 0, line: 3, text: "too fast" };
  const lines = new ConsoleLines([out("a"), note, note, out("b\n"), note, err("c")]);
  expect(plain(lines.after(6))).toEqual([
    "0 a",
    "1 Line 3: too fast",
    "2 Line 3: too fast",
    "3 b",
    "4 Line 3: too fast",
    "5 c",
  ]);
  expect(lines.after(2)[1]?.pieces).toEqual([{ stream: "note", text: "Line 3: too fast" }]);
});

test("only the last lines are kept, and their numbers say how many came before", () => {
  const all = Array.from({ length: MOST_LINES + 500 }, (_, i) => out(`line ${i}\n`));
  const lines = new ConsoleLines(all).after(all.length);
  expect(lines).toHaveLength(MOST_LINES);
  expect(plain(lines.slice(0, 1))).toEqual(["500 line 500"]);
  expect(plain(new ConsoleLines(all).after(700)).slice(-1)).toEqual(["699 line 699"]);
});

test("one print of very many lines", () => {
  const lines = new ConsoleLines([out("x\n".repeat(MOST_LINES + 3))]).after(1);
  expect(lines).toHaveLength(MOST_LINES);
  expect(lines[0]?.number).toBe(3);
});

test("one very long line is cut at its front", () => {
  const lines = new ConsoleLines([out(`first\n${"x".repeat(2 * MOST_CHARACTERS)}end`)]).after(1);
  expect(lines).toHaveLength(1);
  expect(lines[0]?.number).toBe(1);
  expect(lines[0]?.pieces[0]?.text).toHaveLength(MOST_CHARACTERS);
  expect(lines[0]?.pieces[0]?.text.endsWith("xend")).toBe(true);
});

test("prints that come later are taken in", () => {
  const prints = [out("a\n")];
  const lines = new ConsoleLines(prints);
  lines.after(1);
  prints.push(out("b\n"));
  expect(plain(lines.after(2))).toEqual(["0 a", "1 b"]);
});
