/**
 * Hashes of all that a figure comes from, so that a kept one is told from one that has gone stale: its
 * runs (program, world, seed), and what runs them. Imports `files`.
 *
 * @typedef {import("./python-worker.mjs").Job} Job
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { parser } from "@lezer/python";
import { filesBelow, ROOT, sha256 } from "../files.mjs";

const BUGBOT = join(ROOT, "py/bugbot");

/**
 * Modules that are no part of a run, and those that only find words for what went wrong. A figure comes
 * from a run that finished, so none of these can change it.
 */
const NOT_RUNNING =
  /^(__main__|cli|picture|plain_text|shut_in|supervisor|errors|run\/faults|run\/slips\/\w+)\.py$/;

/** Enough to tell any two apart, and short to read in a diff. */
const LENGTH = 12;

/** @type {string | undefined} */
let ours;

/** What runs the programs of this process. */
export function simulatorHash() {
  ours ??= hashOfSimulator(BUGBOT);
  return ours;
}

/**
 * The interpreter with its NumPy, the code of `bugbot`, and how a number is read from a run. A program in
 * the page has nothing else of ours.
 * @param {string} folder that of `bugbot`
 */
export function hashOfSimulator(folder) {
  const pyodide = readFileSync(join(ROOT, "node_modules/pyodide/package.json"), "utf8");
  const reading = readFileSync(new URL("figure-value.mjs", import.meta.url), "utf8");
  const modules = filesBelow(folder, (path) => path.endsWith(".py") && !NOT_RUNNING.test(path));
  const code = modules.map((path) => [path, codeOf(readFileSync(join(folder, path), "utf8"))]);
  return short([JSON.parse(pyodide).version, unixLines(reading), code]);
}

/**
 * @param {readonly Extract<Job, { kind: "run" }>[]} jobs the runs of one figure
 */
export function runsHash(jobs) {
  return short(jobs.map(({ program, world, seed }) => [program, world, seed]));
}

/**
 * Does a program ask how fast the machine is? Nothing but timeit() tells it. Its numbers are measured on the
 * machine at hand each time, as the prose says of them.
 * @param {string} program
 */
export function isTimed(program) {
  return /\btimeit\b/.test(program);
}

/**
 * The code of a Python file without what does nothing: comments, docstrings, blank lines and the way it
 * is laid out. Better words there don't make a figure stale.
 * @param {string} source
 */
export function codeOf(source) {
  const text = unixLines(source);
  let code = "";
  let at = 0;
  /** @param {number} from */
  const upTo = (from) => {
    code += text.slice(at, from).replace(/\s+/g, "");
    at = Math.max(at, from);
  };
  parser.parse(text).iterate({
    enter({ name, from, to, node }) {
      upTo(from);
      if (name === "Comment" || isTextAlone(node)) {
        at = to;
        return false;
      }
      // Where a block ends is told by the indentation alone.
      if (name === "Body" || name === "MatchBody") code += "{";
      if (node.firstChild && name !== "FormatString") return true;
      code += ` ${text.slice(from, to)}`;
      at = to;
      return false;
    },
    leave({ name, to }) {
      upTo(to);
      if (name === "Body" || name === "MatchBody") code += "}";
    },
  });
  upTo(text.length);
  return code;
}

/**
 * Is it a statement that is nothing but a text, as a docstring is?
 * @param {import("@lezer/common").SyntaxNode} node
 */
function isTextAlone({ name, from, to, firstChild }) {
  const isAll = firstChild?.name === "String" && firstChild.from === from && firstChild.to === to;
  return name === "ExpressionStatement" && isAll;
}

/** @param {string} text */
function unixLines(text) {
  return text.replaceAll("\r\n", "\n");
}

/** @param {unknown} inputs */
function short(inputs) {
  return sha256(JSON.stringify(inputs)).slice(0, LENGTH);
}
