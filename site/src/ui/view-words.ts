/**
 * The words of the overhead view, the chart and the console. Imports `counted` and `dom`.
 *
 * The same voice as `strings.ts`: what is so, in plain words, with its unit.
 */
import { counted } from "./counted.ts";
import { seconds } from "./dom.ts";

/** A length in cm as people write it: 127.5, 100. */
const cm = (value: number): string => String(Math.round(value * 10) / 10);
const point = (x: number, y: number): string => `(${cm(x)}, ${cm(y)}) cm`;

const DID = { passed: "passed", ended: "ended here", close: "ended just behind it" };

export const overheadWords = {
  name: "Overhead view",
  cursor: "Cell cursor",
  cursorHelp: "The arrow keys move by a cell, with Shift by five. Escape puts the cursor away.",
  legend: "Shown on the mat",
  ask: "Point at or tap a cell, or press the arrow keys on the mat, to see what speaks for it.",
  bare: "bare mat",
  remove: "Remove",
  removeOf: (name: string) => `Remove ${name}`,
  truth: "really there",
  differs: "unlike the run before",
  otherSize: "cells of another size",
  outlined: "pointed out",
  more: (count: number) => `and ${count} more`,

  /** Of a moment. */
  robot: (x: number, y: number, heading: number) =>
    `robot at (${Math.round(x)}, ${Math.round(y)}) cm, heading ${Math.round(heading) % 360}°`,
  layers: (counts: readonly string[], more: number) =>
    `${counts.join(", ") || "nothing drawn"}${more > 0 ? ` and ${more} more` : ""}`,
  ahead: (name: string, distance: number) => `${name} ${Math.round(distance)} cm ahead`,
  clear: (distance: number) => `nothing within ${distance} cm ahead`,

  pointedOut: (cells: readonly (readonly [x: number, y: number])[], all: number) =>
    `pointed out: ${all === 1 ? "the cell" : `${counted(all, "cell")},`} ${all > cells.length ? "with those " : ""}at ${cells.map(([x, y]) => point(x, y)).join(", ")}`,

  /** Of a cell. */
  cell: (x: number, y: number) => `Cell ${point(x, y)}`,
  drawnAs: (name: string | null) => (name === null ? "is bare mat" : `is drawn as ${name}`),
  isFloor: (near: string, distance: number) => `really floor, ${cm(distance)} cm from the ${near}`,
  isPartly: (name: string) => `really floor, with some of the ${name} in it`,
  isThing: (name: string) => `really the ${name}`,
  untouched: "No beam of this run has touched it so far.",
  evidence: (passed: number, ended: number, close: number) =>
    `So far ${counted(passed, "beam")} passed through it and ${ended || "none"} ended in it${
      close > 0
        ? `; ${close} more ended just behind it, and by the lessons' rule ${close === 1 ? "says" : "say"} nothing about it`
        : ""
    }`,
  last: (t: number, reading: number, did: "passed" | "ended" | "close") =>
    `the last, at ${seconds(t)}, read ${cm(reading)} cm and ${DID[did]}`,
};

export const chartWords = {
  name: "Chart",
  empty: "Nothing plotted yet: plot(name, value) draws a line here",
  none: "–",
  more: (count: number) => `and ${count} more`,
  earlier: "thin: the run before",
  runs: (count: number) => `band: ${counted(count, "run")}, their median in the middle`,
  moment: (lines: number, t: number) =>
    `${counted(lines, "line")} against time, shown at ${seconds(t)}`,
  table: "Values as a table",
  time: "time",
  skipped: (shown: number, all: number) =>
    `${shown} of ${counted(all, "time")}; the CSV file has them all.`,
};

export const consoleWords = {
  name: "Console",
  empty: "What the program prints appears here.",
  error: "error output",
  noteTag: "note",
  note: (line: number, text: string) => `Line ${line}: ${text}`,
  left: (lines: number) => `${counted(lines, "earlier line")} left out`,
};
