/**
 * The small changes of a task's solution, for the authors' page: counts, and those that still pass.
 *
 * @typedef {import("../../src/preview/data.ts").Mutants} Mutants
 */
import { join } from "node:path";
import { keep, kept, mutantsKey } from "./marks.mjs";
import { pythonLines } from "./python-lines.mjs";

const END = ".mutants.json";

/** @param {string} key @returns {Mutants | null} */
export function keptMutants(key) {
  return JSON.parse(kept(key, END) ?? "null");
}

/**
 * Lines {"done", "of"} on the way, and {"mutants"} at the end.
 * @param {string} lessons
 * @param {string} slug
 * @param {string} task
 * @param {import("node:http").ServerResponse} response
 */
export async function sendMutants(lessons, slug, task, response) {
  const key = mutantsKey(join(lessons, slug, task));
  const args = ["-m", "grader", "mutants", slug, task, "--json", "--lessons", lessons];
  // It ends with 1 if some changes pass.
  for await (const line of pythonLines(args, response, [0, 1])) {
    const said = JSON.parse(line);
    if (said.task === task) {
      const { mutants, killed, explained, open, faults, seconds } = said;
      /** @type {Mutants} */
      const found = { mutants, killed, explained, open, faults, seconds };
      keep(key, END, found);
      response.write(`${JSON.stringify({ mutants: found })}\n`);
    } else {
      response.write(`${line}\n`);
    }
  }
}
