/** npm run coverage: which lines and branches of py/ the Python tests reach, other processes' too. */
import { rmSync } from "node:fs";
import { join } from "node:path";
import { CACHE, filesBelow, ROOT, write } from "../site/build/files.mjs";
import { ensureInstalled, run } from "../site/build/install.mjs";

ensureInstalled();
const { ensureVenv, venvTool } = await import("./setup.mjs");
ensureVenv();

const python = join(ROOT, "py");
const folder = join(CACHE, "coverage");
const config = join(folder, "coverage.ini");
// What stands on Pyodide's own modules is run by the browser's tests alone.
const browserOnly = ["session", "marking"].map((name) => join(python, "bridge", `${name}.py`));
write(
  config,
  `[run]
branch = true
parallel = true
patch =
    subprocess
    _exit
sigterm = true
data_file = ${join(folder, "data")}
source = ${["bugbot", "mapping", "performer", "grader", "bridge"].map((name) => join(python, name)).join("\n    ")}
omit = ${browserOnly.join("\n    ")}

[report]
skip_covered = true
show_missing = true
exclude_also =
    if TYPE_CHECKING:
    raise NotImplementedError
`,
);
const coverage = venvTool("coverage");
const options = { cwd: python };
run(coverage, ["erase", `--rcfile=${config}`], options);
run(coverage, ["run", `--rcfile=${config}`, "-m", "pytest"], options);
run(coverage, ["combine", "--quiet", `--rcfile=${config}`], options);
// Of processes that were killed while they wrote: empty, and reported again and again.
for (const name of filesBelow(folder, (path) => path.startsWith("data."))) {
  rmSync(join(folder, name));
}
run(coverage, ["report", `--rcfile=${config}`], options);
