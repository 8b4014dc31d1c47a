/**
 * Marks for the authors' page, from CPython on this machine. They are kept in .cache/ by the content of
 * all that they depend on, so what has not changed is not marked again.
 *
 * @typedef {import("../../src/preview/data.ts").Told} Told
 * @typedef {import("node:http").ServerResponse} Response
 */
import { existsSync, readdirSync, readFileSync, rmSync, statSync } from "node:fs";
import { dirname, join } from "node:path";
import { CACHE, filesBelow, hashOfFiles, ROOT, sha256, write } from "../files.mjs";
import { pythonLines } from "./python-lines.mjs";

const KEPT = join(CACHE, "preview");
const KEY = /^[0-9a-f]{64}$/;
/** What nobody has asked for in so long is thrown away [ms]. */
const LONG = 14 * 24 * 3600 * 1000;

/** Throws away what is old. */
export function forgetOld() {
  if (!existsSync(KEPT)) return;
  for (const name of readdirSync(KEPT)) {
    const path = join(KEPT, name);
    if (Date.now() - statSync(path).mtimeMs > LONG) rmSync(path, { force: true });
  }
}

// -- what a mark depends on --------------------------------------------------------

/**
 * @param {string} task its folder
 * @param {string} file from there
 */
export function keyOf(task, file) {
  return keyOfFiles(task, [file, "starter.py", "check.py"]);
}

/** @param {string} task its folder */
export function mutantsKey(task) {
  return keyOfFiles(task, ["solution.py", "starter.py", "check.py", "equivalent.json"]);
}

/**
 * @param {string} task
 * @param {string[]} files
 */
function keyOfFiles(task, files) {
  const lesson = dirname(task);
  const worlds = filesBelow(join(lesson, "worlds")).map((path) => join(lesson, "worlds", path));
  const own = [...files.map((file) => join(task, file)), join(lesson, "lesson.json"), ...worlds];
  const there = own.filter((path) => existsSync(path));
  return sha256(`${grader()} ${files[0]} ${hashOfFiles(there)}`);
}

/** The state of all that marks. */
function grader() {
  const folders = ["bugbot", "mapping", "grader", "performer"].map((name) =>
    join(ROOT, "py", name),
  );
  const files = folders.flatMap((folder) =>
    filesBelow(folder, (path) => /\.(py|json)$/.test(path)).map((path) => join(folder, path)),
  );
  return hashOfFiles(files);
}

// -- what is kept ------------------------------------------------------------------

/**
 * @param {string} key
 * @param {string} end of the file's name
 * @returns {string | null}
 */
export function kept(key, end) {
  const path = join(KEPT, `${key}${end}`);
  return KEY.test(key) && existsSync(path) ? readFileSync(path, "utf8") : null;
}

/**
 * @param {string} key
 * @param {string} end of the file's name
 * @param {unknown} value
 */
export function keep(key, end, value) {
  write(join(KEPT, `${key}${end}`), JSON.stringify(value));
}

/** @param {string} key @returns {Told | null} */
export function keptTold(key) {
  return JSON.parse(kept(key, ".mark.json") ?? "null");
}

/** The run in which a check failed, as JSON. @param {string} key */
export function keptRun(key) {
  return kept(key, ".run.json");
}

// -- marking -------------------------------------------------------------------------

/**
 * A line for each file, as soon as it is marked: {"file", "key", "told"}, or {"file", "trouble"}.
 * @param {string} lessons
 * @param {string} slug
 * @param {string} task
 * @param {string[]} files from the task's folder
 * @param {Response} response
 */
export async function sendMarks(lessons, slug, task, files, response) {
  const folder = join(lessons, slug, task);
  const sound = files.filter((file) => /^(?:(?:right|wrong)\/)?[\w.-]+\.py$/.test(file));
  // Of the texts that are there before the marking: one that changes meanwhile is marked again.
  const keys = new Map(sound.map((file) => [file, keyOf(folder, file)]));
  const args = ["-m", "grader.classes.preview", lessons, slug, task, ...sound];
  for await (const line of pythonLines(args, response)) {
    const { file, mark, causes, seconds, run, trouble } = JSON.parse(line);
    const key = keys.get(file) ?? "";
    if (trouble !== undefined) {
      response.write(`${JSON.stringify({ file, trouble })}\n`);
      continue;
    }
    /** @type {Told} */
    const told = { mark, causes, seconds, hasRun: run !== null };
    keep(key, ".mark.json", told);
    if (run !== null) keep(key, ".run.json", run);
    response.write(`${JSON.stringify({ file, key, told })}\n`);
  }
}
