/**
 * npm run lesson:check [-- SLUG… --seeds N --one-in M]: the standing check of these lessons, or of the
 * whole course; a solution must pass with N noises (20), and one in M of the right and wrong programs
 * is marked (all).
 * First the tasks, in Python: starters fail, solutions pass, wrong attempts earn their message. Then
 * the pages: every directive, figure and link. Ends with a fault if either finds one.
 */
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { delimiter, join } from "node:path";
import { parseArgs } from "node:util";
import { ROOT } from "./files.mjs";
import { ensureInstalled, fail } from "./install.mjs";

ensureInstalled();
const { ensureVenv, venvTool } = await import("../../tests/setup.mjs");
ensureVenv();

const { values, positionals: slugs } = parseArgs({
  allowPositionals: true,
  options: { seeds: { type: "string" }, "one-in": { type: "string" } },
});
const options = Object.entries(values).flatMap(([name, value]) => [`--${name}`, value]);
for (const slug of slugs) {
  if (!existsSync(join(ROOT, "lessons", slug, "lesson.json"))) {
    fail(`There is no lesson "${slug}".`, "name a folder of lessons/ that has a lesson.json.");
  }
}
const { PYTHONPATH } = process.env;
const path = [join(ROOT, "py"), ...(PYTHONPATH ? [PYTHONPATH] : [])].join(delimiter);
const tasks = check(venvTool("python"), ["-m", "grader", "check", ...slugs, ...options], {
  PYTHONPATH: path,
});

/** @type {string[]} */
const course = JSON.parse(readFileSync(join(ROOT, "lessons/course.json"), "utf8")).lessons;
const pages = [...(slugs.length > 0 ? slugs : course)];
const prose = pages.length === 0 || check("node", ["site/build/lessons/check.mjs", ...pages]);
process.exit(tasks && prose ? 0 : 1);

/**
 * Run one check with its output shown; whether all is well.
 * @param {string} command
 * @param {string[]} args
 * @param {Record<string, string>} [environment]
 */
function check(command, args, environment = {}) {
  const done = spawnSync(command, args, {
    cwd: ROOT,
    stdio: "inherit",
    env: { ...process.env, ...environment },
  });
  if (done.error) fail(`${command} could not be started: ${done.error.message}`);
  return done.status === 0;
}
