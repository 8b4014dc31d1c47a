/**
 * npm run lesson:mutants [-- LESSON … | LESSON TASK] [--sample N --seed S] [--list] [--json]: python -m
 * grader mutants. Changes the learner's part of each solution in small ways, one at a time; a change that
 * passes its checks, and that no equivalent.json explains, is open, and ends this with a fault.
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
const env = { ...process.env, PYTHONPATH: path };
const done = spawnSync(venvTool("python"), args, { cwd: ROOT, stdio: "inherit", env });
if (done.error) fail(`Python could not be started: ${done.error.message}`);
process.exit(done.status ?? 1);
