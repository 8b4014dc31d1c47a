/** The trace that a program leaves under plain CPython, to hold a browser's against. */
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { isDeepStrictEqual } from "node:util";
import { ROOT } from "../site/build/files.mjs";
import { venvTool } from "./setup.mjs";

/**
 * @param {{ file: string, world: string, seed: number }} run
 * @returns {string} the text of the trace file
 */
export function nativeTrace({ file, world, seed }) {
  const folder = mkdtempSync(join(tmpdir(), "trace-"));
  const out = join(folder, "native.trace");
  const args = [
    "-m",
    "bugbot",
    "run",
    "--trusted",
    file,
    "--world",
    world,
    "--seed",
    `${seed}`,
    "--trace",
    out,
  ];
  const env = { ...process.env, PYTHONPATH: join(ROOT, "py") };
  const done = spawnSync(venvTool("python"), args, { env, encoding: "utf8" });
  if (done.status !== 0) throw new Error(`${file} has failed under CPython:\n${done.stderr}`);
  const text = readFileSync(out, "utf8");
  rmSync(folder, { recursive: true });
  return text;
}

/**
 * Where two traces part, in words; an empty text if they never do.
 *
 * The header may have its fields in another order, and 5 and 5.0 are two spellings of one number.
 * @param {string} got
 * @param {string} expected
 */
export function partingOf(got, expected) {
  const rows = [got, expected].map((text) => text.trimEnd().split("\n"));
  const [ours = [], theirs = []] = rows;
  if (!same(ours[0] ?? "null", theirs[0] ?? "null")) return `header: ${ours[0]} / ${theirs[0]}`;
  const row = ours.findIndex((text, index) => index > 0 && !same(text, theirs[index] ?? "null"));
  if (row !== -1) return `row ${row}: ${ours[row]} / ${theirs[row]}`;
  return ours.length === theirs.length ? "" : `${ours.length} rows / ${theirs.length} rows`;
}

/** @param {string} a @param {string} b */
function same(a, b) {
  return a === b || isDeepStrictEqual(JSON.parse(a), JSON.parse(b));
}

/**
 * The outcome of a program under plain CPython, to hold a browser's against.
 * @param {{ program: string, world: string, seed: number }} run
 * @returns {unknown}
 */
export function nativeOutcome({ program, world, seed }) {
  const args = [
    "-m",
    "bugbot",
    "run",
    "--trusted",
    "-",
    "--world",
    world,
    "--seed",
    `${seed}`,
    "--json",
  ];
  const env = { ...process.env, PYTHONPATH: join(ROOT, "py") };
  const done = spawnSync(venvTool("python"), args, { env, encoding: "utf8", input: program });
  if (done.status !== 0) throw new Error(`the program has failed under CPython:\n${done.stderr}`);
  return JSON.parse(done.stdout);
}
