/**
 * npm run lesson:mutants [-- LESSON [TASK] --sample N]: changes the learner's part of every solution a
 * little, as a learner might; each change must fail, or have its reason in the task's equivalent.json.
 */
import { spawnSync } from "node:child_process";
import { delimiter, join } from "node:path";
import { ROOT } from "./files.mjs";
import { ensureInstalled, fail } from "./install.mjs";

ensureInstalled();
const { ensureVenv, venvTool } = await import("../../tests/setup.mjs");
ensureVenv();

const { PYTHONPATH } = process.env;
const path = [join(ROOT, "py"), ...(PYTHONPATH ? [PYTHONPATH] : [])].join(delimiter);
const args = ["-m", "grader", "mutants", ...process.argv.slice(2)];
const done = spawnSync(venvTool("python"), args, {
  cwd: ROOT,
  stdio: "inherit",
  env: { ...process.env, PYTHONPATH: path },
});
if (done.error) fail(`Python could not be started: ${done.error.message}`);
process.exit(done.status ?? 1);
