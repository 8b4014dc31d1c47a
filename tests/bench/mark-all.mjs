/** npm run mark-all:bench: mark_all.py in the tests' Python, which is set up if it is missing. */
import { join } from "node:path";
import { ROOT } from "../../site/build/files.mjs";
import { ensureInstalled, run } from "../../site/build/install.mjs";

ensureInstalled();
const { ensureVenv, venvTool } = await import("../setup.mjs");
ensureVenv();

run(venvTool("python"), [join(ROOT, "tests/bench/mark_all.py"), ...process.argv.slice(2)], {
  env: { ...process.env, PYTHONPATH: join(ROOT, "py") },
});
