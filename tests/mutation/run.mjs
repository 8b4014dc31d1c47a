/**
 * npm run mutate [-- TARGET…]: changes the code in thousands of small ways, one at a time, and looks
 * whether a test notices. What no test notices is either untested or does not matter: the list is
 * there to be read. mutmut does the work, in a copy under .cache/mutation; it goes on where it was
 * stopped. Takes the better part of an hour: nothing for `npm test`.
 */
import { spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, rmSync, writeFileSync } from "node:fs";
import { cpus } from "node:os";
import { join } from "node:path";
import { CACHE, ROOT } from "../../site/build/files.mjs";
import { ensureInstalled, fail, run } from "../../site/build/install.mjs";
import { findPython } from "../../site/build/tools.mjs";

ensureInstalled();

const MUTMUT = "mutmut==3.8.1";
const PACKAGES = ["bugbot", "mapping", "grader", "bridge", "sketch"];

/**
 * What is changed, and the tests that should notice.
 * @type {Record<string, { only: string[], tests: string[] }>}
 */
const TARGETS = {
  mapping: { only: ["mapping/*.py"], tests: ["tests/py/mapping"] },
  grader: {
    only: ["compare", "values", "scans", "maps", "lines", "slips", "marks", "trials"].map(
      (name) => `grader/${name}.py`,
    ),
    tests: [
      "tests/py/grader/test_compare.py",
      "tests/py/grader/test_values.py",
      "tests/py/grader/test_functions.py",
      "tests/py/grader/test_judge.py",
      "tests/py/grader/test_runs.py",
      "tests/py/grader/test_trials.py",
    ],
  },
};

/** How mutmut ends what it says of a mutant that is still alive. */
const ALIVE = /: (survived|no tests|suspicious)$/;

const names = process.argv.slice(2);
for (const name of names.length > 0 ? names : Object.keys(TARGETS)) {
  const target = TARGETS[name];
  if (!target)
    fail(`There is no target "${name}".`, `name one of ${Object.keys(TARGETS).join(", ")}.`);
  mutate(name, target);
}

/**
 * @param {string} name
 * @param {{ only: string[], tests: string[] }} target
 */
function mutate(name, { only, tests }) {
  const project = join(CACHE, "mutation", name);
  // mutmut wants packages at the top; what some tests read lies where it does in the repository.
  for (const part of PACKAGES) copy(join(ROOT, "py", part), join(project, part));
  for (const part of ["py", "lessons"]) copy(join(ROOT, part), join(project, part));
  for (const part of ["conftest.py", "golden", "lessons", "py"]) {
    copy(join(ROOT, "tests", part), join(project, "tests", part));
  }
  writeFileSync(
    join(project, "pyproject.toml"),
    `[tool.mutmut]
source_paths = ["${name}"]
only_mutate = ${JSON.stringify(only)}
pytest_add_cli_args_test_selection = ${JSON.stringify(tests)}
pytest_add_cli_args = ["-p", "no:cacheprovider", "-x"]
also_copy = ${JSON.stringify([...PACKAGES.filter((part) => part !== name), "py", "lessons", "tests"])}
use_git_change_detection = false

[tool.pytest.ini_options]
pythonpath = [".", "tests"]
`,
  );
  const mutmut = tool();
  const processes = `${Math.max(1, cpus().length)}`;
  console.log(`\n== ${name}`);
  spawnSync(mutmut, ["run", "--max-children", processes], { cwd: project, stdio: "inherit" });
  const { stdout } = spawnSync(mutmut, ["results", "--all", "true"], {
    cwd: project,
    encoding: "utf8",
  });
  const all = stdout.split("\n").filter((line) => /__mutmut_\d+: /.test(line));
  const alive = all.filter((line) => ALIVE.test(line));
  const report = join(project, "alive.txt");
  writeFileSync(report, `${alive.map((line) => line.trim()).join("\n")}\n`);
  const percent = ((100 * (all.length - alive.length)) / Math.max(1, all.length)).toFixed(1);
  console.log(
    `${name}: ${all.length} mutants, ${percent} % noticed, ${alive.length} not: ${report}`,
  );
}

/** mutmut, in an environment of its own. */
function tool() {
  const venv = join(CACHE, "mutation/venv");
  const bin = join(venv, process.platform === "win32" ? "Scripts" : "bin");
  if (!existsSync(join(bin, "mutmut"))) {
    run(findPython(), ["-m", "venv", venv]);
    const requirements = join(ROOT, "tests/requirements.txt");
    const quiet = ["--quiet", "--disable-pip-version-check"];
    run(join(bin, "python"), ["-m", "pip", "install", ...quiet, "-r", requirements, MUTMUT]);
  }
  return join(bin, "mutmut");
}

/**
 * @param {string} from
 * @param {string} to
 */
function copy(from, to) {
  rmSync(to, { recursive: true, force: true });
  mkdirSync(join(to, ".."), { recursive: true });
  const filter = (/** @type {string} */ path) =>
    !/__pycache__|\.mypy_cache|\.pytest_cache/.test(path);
  cpSync(from, to, { recursive: true, filter });
}
