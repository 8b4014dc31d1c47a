/** npm run fuzz [-- CASES]: damaged files for every reader, in Python and in the page. */
import { join } from "node:path";
import { ROOT } from "../../site/build/files.mjs";
import { ensureInstalled, run } from "../../site/build/install.mjs";

ensureInstalled();
const { ensureVenv, venvTool } = await import("../setup.mjs");
ensureVenv();
const cases = process.argv[2] ?? "20000";
run(venvTool("python"), ["-m", "fuzz", "--cases", cases], {
  cwd: join(ROOT, "tests"),
  env: { ...process.env, PYTHONPATH: join(ROOT, "py") },
});
run(
  "npx",
  ["playwright", "test", "-c", "tests/playwright.config.ts", "--project=unit", "unit/fuzz"],
  {
    env: { ...process.env, FUZZ_CASES: cases },
  },
);
