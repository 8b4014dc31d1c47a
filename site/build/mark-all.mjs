/**
 * npm run mark-all -- FOLDER […]: python -m grader mark-all, with the Python that is there. npm
 * changes to the project's folder; the folder that is named counts from where one is.
 */
import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { delimiter, join } from "node:path";
import { messageOf, ROOT } from "./files.mjs";
import { ensureInstalled, fail } from "./install.mjs";
import { findPython } from "./tools.mjs";

ensureInstalled();
const { PYTHONPATH } = process.env;
const path = [join(ROOT, "py"), ...(PYTHONPATH ? [PYTHONPATH] : [])].join(delimiter);
const done = spawnSync(python(), ["-m", "grader", "mark-all", ...process.argv.slice(2)], {
  cwd: process.env.INIT_CWD ?? process.cwd(),
  stdio: "inherit",
  env: { ...process.env, PYTHONPATH: path },
});
if (done.error) fail(`Python could not be started: ${done.error.message}`);
process.exit(done.status ?? 1);

/** That of the tests' environment, which has NumPy and dask, or else the system's. */
function python() {
  const own = join(ROOT, ".venv/bin/python");
  if (existsSync(own)) return own;
  try {
    return findPython();
  } catch (error) {
    fail(messageOf(error));
  }
}
