/**
 * What is wrong with something an instructor wrote: which file and line, what, and what to do.
 * Faults are gathered, so that one build reports all of them. Imports nothing of ours but `files`.
 *
 * @typedef {{ file: string, line: number | null, fault: string, remedy: string }} Fault
 */
import { relative, sep } from "node:path";
import { ROOT } from "../files.mjs";

/** Every fault found in the lessons; its message lists them for the terminal. */
export class LessonFaults extends Error {
  /** @param {readonly Fault[]} faults */
  constructor(faults) {
    const inOrder = [...faults].sort(
      (a, b) => a.file.localeCompare(b.file) || (a.line ?? 0) - (b.line ?? 0),
    );
    const count = faults.length === 1 ? "1 fault" : `${faults.length} faults`;
    super(`${count} in the lessons:\n\n${inOrder.map(faultText).join("\n\n")}`);
    this.name = "LessonFaults";
    this.faults = inOrder;
    // Where in the build they were found is of no use to who wrote the lesson.
    this.stack = this.message;
  }
}

/**
 * One fault as a terminal shows it; editors make `file:line` a link.
 * @param {Fault} fault
 */
export function faultText({ file, line, fault, remedy }) {
  return `${placeText(file, line)}: ${fault}\n    Remedy: ${remedy}`;
}

/**
 * @param {string} file
 * @param {number | null} line
 */
export function placeText(file, line) {
  return line === null ? file : `${file}:${line}`;
}

/**
 * A path as messages name it: from the project's folder, with forward slashes.
 * @param {string} path
 */
export function shownPath(path) {
  return relative(ROOT, path).split(sep).join("/");
}

/**
 * "a, b and c", for messages that say what there is.
 * @param {readonly string[]} words
 */
export function listText(words) {
  if (words.length === 0) return "none";
  if (words.length === 1) return words[0] ?? "";
  return `${words.slice(0, -1).join(", ")} and ${words.at(-1)}`;
}
