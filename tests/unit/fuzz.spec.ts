/**
 * Damaged files and messages: each reader takes or refuses them, and no other error comes of it.
 * `npm run fuzz` gives FUZZ_CASES of them; here there are a few.
 */

import { cpSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "@playwright/test";
import { ROOT } from "../../site/build/files.mjs";
import { readLesson } from "../../site/build/lessons/folder.mjs";
import { Prose } from "../../site/build/lessons/prose.mjs";
import {
  merged,
  NO_PROGRESS,
  readProgress,
  writeProgress,
} from "../../site/src/page/progress-record.ts";
import { isFromWorker } from "../../site/src/runtime/messages.ts";
import { TraceError } from "../../site/src/trace/decode.ts";
import { readTraceFile, writeTraceFile } from "../../site/src/trace/file.ts";
import { TWO_SECONDS, traceOf } from "./traces.ts";

const CASES = Number(process.env.FUZZ_CASES ?? 150);

test.setTimeout(60_000 + CASES * 20);

/** Numbers from 0 to below 1, the same for the same seed (mulberry32). */
function chance(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

const TOKENS = [
  "",
  "\0",
  "\n",
  "-",
  "0",
  "1e999",
  "null",
  "true",
  '"',
  "[",
  "]",
  "{",
  "}",
  ",",
  "{{",
  "}}",
  "$",
].concat(["$$", "::", "```", "|", "\ufeff", "🤖", "[[[[[[[[", "# ", "> "]);
const VALUES: readonly unknown[] = [
  null,
  true,
  0,
  -1,
  1.5,
  1e308,
  "",
  "x",
  "x".repeat(5000),
  [],
  {},
  [null],
];

/** One to four pieces cut out, doubled, put elsewhere, or overwritten with something awkward. */
function damaged(text: string, random: () => number): string {
  const upTo = (most: number): number => Math.floor(random() * most);
  let now = text;
  for (let i = upTo(4); i >= 0; i--) {
    const at = upTo(now.length + 1);
    const length = [1, 1, 2, 8, 64, 1024][upTo(6)] ?? 1;
    const piece = now.slice(at, at + length);
    const rest = now.slice(0, at) + now.slice(at + length);
    const to = upTo(rest.length + 1);
    const put = [rest.slice(0, to) + piece + rest.slice(to), rest, now.slice(0, at), null][upTo(4)];
    now = put ?? now.slice(0, at) + (TOKENS[upTo(TOKENS.length)] ?? "") + now.slice(at + length);
  }
  return now;
}

/** The same data with one value, somewhere in it, replaced. */
function damagedData(data: unknown, random: () => number): unknown {
  const copy = structuredClone(data);
  const places: [Record<string, unknown>, string][] = [];
  const walk = (value: unknown): void => {
    if (typeof value !== "object" || value === null) return;
    for (const [key, each] of Object.entries(value)) {
      places.push([value as Record<string, unknown>, key]);
      walk(each);
    }
  };
  walk(copy);
  const [holder, key] = places[Math.floor(random() * places.length)] ?? [];
  if (holder && key) holder[key] = VALUES[Math.floor(random() * VALUES.length)];
  return copy;
}

/** Counts the cases that were taken; a case that breaks the reader is named by its number. */
function fuzz(name: string, takes: (random: () => number) => boolean): void {
  test(`${name}: ${CASES} damaged ones are taken or refused`, () => {
    let taken = 0;
    for (let number = 0; number < CASES; number++) {
      try {
        if (takes(chance(number))) taken += 1;
      } catch (error) {
        throw new Error(`${name}, case ${number}`, { cause: error });
      }
    }
    console.log(`${name.padEnd(26)} ${CASES} cases: ${taken} taken, ${CASES - taken} refused`);
    expect(taken).toBeLessThan(CASES);
  });
}

const traceFile = writeTraceFile(
  traceOf(TWO_SECONDS, [10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120]),
);

test("the good files are good", () => {
  expect(readTraceFile(traceFile).duration).toBeGreaterThan(0);
  expect(readProgress(progress)).toBeInstanceOf(Object);
});

fuzz("trace file (page)", (random) => {
  const lines = traceFile.trimEnd().split("\n");
  const at = Math.floor(random() * lines.length);
  lines[at] = JSON.stringify(damagedData(JSON.parse(lines[at] ?? ""), random));
  const text = random() < 0.5 ? damaged(traceFile, random) : `${lines.join("\n")}\n`;
  try {
    // What was taken can be written and read again.
    const trace = readTraceFile(text);
    expect(writeTraceFile(readTraceFile(writeTraceFile(trace)))).toBe(writeTraceFile(trace));
    return true;
  } catch (error) {
    if (error instanceof TraceError) return false;
    throw error;
  }
});

const progress = writeProgress({
  tasks: new Map([
    ["u8-1/a", { state: "passed", hints: 2, solution: true, at: 1_760_000_000_000 }],
    ["u8-1/b", { state: "tried", hints: 0, solution: false, at: 1_760_000_100_000 }],
  ]),
  last: { lesson: "u8-1", task: "b" },
});

fuzz("progress", (random) => {
  const data = JSON.stringify(damagedData(JSON.parse(progress), random));
  const read = readProgress(random() < 0.3 ? damaged(progress, random) : data);
  if (typeof read === "string") return false;
  // It can be written, and merged with what there is.
  expect(readProgress(writeProgress(merged(NO_PROGRESS, read)))).toEqual(read);
  return true;
});

fuzz("a worker's message", (random) => {
  const chunk = { kind: "chunk", id: 0, events: "[]", points: new ArrayBuffer(4) };
  const imports = { kind: "imports", id: 0, missing: ["numpy"], hasStdlib: true };
  const died = { kind: "died", id: 0, reason: "fatal", line: 3, message: "broken" };
  const [message = chunk] = [[chunk], [imports], [died]][Math.floor(random() * 3)] ?? [];
  return isFromWorker(damagedData(message, random));
});

const lesson = join(ROOT, "lessons/u8-2-inverse-sensor-model");

test(`lesson folder (build): ${CASES} damaged ones are told as faults`, () => {
  const copy = test.info().outputPath("u8-2-inverse-sensor-model");
  cpSync(lesson, copy, { recursive: true });
  const json = readFileSync(join(lesson, "lesson.json"), "utf8");
  const folder = join(ROOT, "py/bugbot/worlds");
  const worlds = readdirSync(folder)
    .filter((name) => name.endsWith(".json"))
    .map((name) => JSON.parse(readFileSync(join(folder, name), "utf8")));
  let faultless = 0;
  for (let number = 0; number < CASES; number++) {
    const random = chance(number);
    const data = JSON.stringify(damagedData(JSON.parse(json), random));
    writeFileSync(join(copy, "lesson.json"), random() < 0.4 ? damaged(json, random) : data);
    try {
      if (readLesson(copy, worlds).faults.length === 0) faultless++;
    } catch (error) {
      throw new Error(`lesson folder, case ${number}`, { cause: error });
    }
  }
  console.log(`lesson folder (build)      ${CASES} cases: ${faultless} without fault`);
  expect(faultless).toBeLessThan(CASES);
});

test("damaged prose of a lesson is parsed, with faults at most", () => {
  const text = readFileSync(join(lesson, "lesson.md"), "utf8");
  // A whole lesson takes some 30 ms.
  const cases = Math.ceil(CASES / 10);
  for (let number = 0; number < cases; number++) {
    const prose = new Prose();
    try {
      prose.parse(damaged(text, chance(number)), { file: "lesson.md", line: 1 });
    } catch (error) {
      throw new Error(`lesson prose, case ${number}`, { cause: error });
    }
    for (const { line, fault, remedy } of prose.faults) {
      expect(fault && remedy && line).toBeTruthy();
    }
  }
  console.log(`lesson prose               ${cases} cases: all parsed`);
});
