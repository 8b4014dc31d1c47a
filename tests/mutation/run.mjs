/**
 * npm run mutate [-- TARGET…]: changes the code in thousands of small ways, one at a time, and looks
 * whether a test notices. What no test notices is either untested or does not matter: the list is
 * there to be read. mutmut does the work, in a copy under .cache/mutation; it goes on where it was
 * stopped, and tries anew what no test noticed. Takes the better part of an hour: nothing for `npm test`.
 */
import { spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, rmSync, writeFileSync } from "node:fs";
import { cpus } from "node:os";
import { join } from "node:path";
import { CACHE, ROOT } from "../../site/build/files.mjs";
import { ensureInstalled, fail } from "../../site/build/install.mjs";

ensureInstalled();
const { ensureVenv, venvTool } = await import("../setup.mjs");

/** An environment of its own: mutmut brings packages that nothing else here wants. */
const VENV = join(CACHE, "mutation/venv");
const MUTMUT = "mutmut==3.8.1";
const PACKAGES = ["bugbot", "mapping", "performer", "sandbox", "grader", "bridge", "sketch"];

/**
 * What is changed, and the tests that should notice.
 * @type {Record<string, { only: string[], tests: string[] }>}
 */
const TARGETS = {
  mapping: { only: ["mapping/*.py"], tests: ["tests/py/mapping"] },
  grader: {
    only: [
      ...["compare", "scans", "maps", "lines", "slips", "marks", "trials"].map(
        (name) => `grader/${name}.py`,
      ),
      "performer/values.py",
    ],
    tests: [
      "tests/py/grader/test_compare.py",
      "tests/py/grader/test_values.py",
      "tests/py/grader/test_functions.py",
      "tests/py/grader/test_judge.py",
      "tests/py/grader/test_lines.py",
      "tests/py/grader/test_maps.py",
      "tests/py/grader/test_marks.py",
      "tests/py/grader/test_scans.py",
      "tests/py/grader/test_runs.py",
      "tests/py/grader/test_trials.py",
    ],
  },
};

/** How mutmut ends what it says of a mutant that is still alive. */
const ALIVE = /: (survived|no tests|suspicious)$/;

ensureVenv(VENV, [MUTMUT]);
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
  const mutants = join(project, "mutants");
  const before = existsSync(mutants) ? results(project).filter(isAlive) : [];
  // mutmut makes its own copy of the tests but once.
  if (before.length > 0) copy(join(project, "tests"), join(mutants, "tests"));
  console.log(`\n== ${name}`);
  const start = ["run", "--max-children", `${Math.max(1, cpus().length)}`];
  mutmut(project, start, "inherit");
  if (before.length > 0) mutmut(project, [...start, ...before.map(nameOf)], "inherit");

  const all = results(project);
  const alive = all.filter(isAlive);
  const report = join(project, "alive.txt");
  writeFileSync(report, `${alive.join("\n")}\n`);
  const percent = ((100 * (all.length - alive.length)) / Math.max(1, all.length)).toFixed(1);
  console.log(
    `${name}: ${all.length} mutants, ${percent} % noticed, ${alive.length} not: ${report}`,
  );
}

/**
 * What mutmut knows of each mutant: "its.name: survived".
 * @param {string} project
 */
function results(project) {
  const { stdout } = mutmut(project, ["results", "--all", "true"], "pipe");
  return stdout.split("\n").flatMap((line) => (/__mutmut_\d+: /.test(line) ? [line.trim()] : []));
}

/** @param {string} result */
function isAlive(result) {
  return ALIVE.test(result);
}

/** @param {string} result */
function nameOf(result) {
  return result.slice(0, result.indexOf(":"));
}

/**
 * @param {string} project
 * @param {string[]} args
 * @param {"inherit" | "pipe"} stdio
 */
function mutmut(project, args, stdio) {
  return spawnSync(venvTool("mutmut", VENV), args, { cwd: project, encoding: "utf8", stdio });
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
