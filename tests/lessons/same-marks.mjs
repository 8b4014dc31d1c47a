/**
 * node tests/lessons/same-marks.mjs [--few] [SLUG…]: every starter, solution and wrong attempt of the
 * course gets the same mark from CPython and from Pyodide, the browser's Python. The two work side
 * by side. With --few, of every third task the solution and one wrong attempt, as npm test does: all
 * of them take some minutes.
 */
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { isDeepStrictEqual } from "node:util";
import { loadPyodide } from "pyodide";
import { filesBelow, ROOT } from "../../site/build/files.mjs";
import { fail } from "../../site/build/install.mjs";
import { numpyWheel } from "../../site/build/numpy.mjs";
import { venvTool } from "../setup.mjs";

const LESSONS = join(ROOT, "lessons");
const MARKS = join(ROOT, "tests/lessons/marks.py");

const few = process.argv.includes("--few");
const asked = process.argv.slice(2).filter((each) => each !== "--few");
/** @type {string[]} */
const slugs = asked.length > 0 ? asked : readJson(join(LESSONS, "course.json")).lessons;
const work = slugs.flatMap(workOf);
const began = Date.now();
const [native, browser] = await Promise.all([inCPython(), inPyodide()]);
let different = 0;
for (const [index, { slug, task, file }] of work.entries()) {
  if (isDeepStrictEqual(native[index], browser[index])) continue;
  different += 1;
  console.log(`\n${slug}/${task}/${file} is marked in two ways`);
  console.log(`CPython: ${JSON.stringify(native[index]).slice(0, 1000)}`);
  console.log(`Pyodide: ${JSON.stringify(browser[index]).slice(0, 1000)}`);
}
const seconds = Math.round((Date.now() - began) / 1000);
console.log(`${work.length} programs marked twice in ${seconds} s: ${different} differ`);
if (work.length === 0) fail("There was nothing to mark.");
process.exit(different > 0 ? 1 : 0);

/** @param {string} slug */
function workOf(slug) {
  const folder = join(LESSONS, slug);
  const hidden = filesBelow(join(folder, "worlds"));
  const worlds = Object.fromEntries(
    hidden.map((file) => [file.replace(/\.json$/, ""), readJson(join(folder, "worlds", file))]),
  );
  const tasks = /** @type {{ name: string }[]} */ (readJson(join(folder, "lesson.json")).tasks);
  return tasks
    .filter((_task, index) => !few || index % 3 === 0)
    .flatMap(({ name }) => {
      const wrong = join(folder, name, "wrong");
      const attempts = existsSync(wrong)
        ? readdirSync(wrong).filter((file) => file.endsWith(".py"))
        : [];
      const wrongs = attempts.sort().map((file) => `wrong/${file}`);
      const files = few
        ? ["solution.py", ...wrongs.slice(0, 1)]
        : ["starter.py", "solution.py", ...wrongs];
      const check = read(join(folder, name, "check.py"));
      const starter = read(join(folder, name, "starter.py"));
      return files.map((file) => ({
        ...{ slug, worlds, task: name, file, check, starter },
        program: read(join(folder, name, file)),
      }));
    });
}

/** @returns {Promise<unknown[]>} */
async function inCPython() {
  const folder = mkdtempSync(join(tmpdir(), "same-marks-"));
  try {
    const [source, target] = [join(folder, "work.json"), join(folder, "marks.json")];
    writeFileSync(source, JSON.stringify(work));
    const env = { ...process.env, PYTHONPATH: join(ROOT, "py") };
    const child = spawn(venvTool("python"), [MARKS, source, target], { env, stdio: "inherit" });
    const status = await new Promise((resolve) => child.on("exit", resolve));
    if (status !== 0) fail(`CPython ended with ${status}.`);
    return readJson(target);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** @returns {Promise<unknown[]>} */
async function inPyodide() {
  const python = await loadPyodide({ env: { HOME: "/home/pyodide", PYTHONHASHSEED: "0" } });
  const wheel = await numpyWheel((text) => console.log(text));
  python.unpackArchive(new Uint8Array(wheel.bytes), "wheel");
  const site = "/home/pyodide/ours";
  for (const name of ["bugbot", "performer", "mapping", "sandbox", "grader"]) {
    for (const file of filesBelow(join(ROOT, "py", name), (path) => /\.(py|json)$/.test(path))) {
      const path = `${site}/${name}/${file}`;
      python.FS.mkdirTree(path.slice(0, path.lastIndexOf("/")));
      python.FS.writeFile(path, read(join(ROOT, "py", name, file)));
    }
  }
  python.FS.writeFile(`${site}/marks.py`, read(MARKS));
  const marks = python.runPython(
    `import sys; sys.path.insert(0, "${site}")\nfrom marks import marks\nmarks`,
  );
  return JSON.parse(marks(JSON.stringify(work)));
}

/** @param {string} path */
function read(path) {
  return readFileSync(path, "utf8");
}

/** @param {string} path */
function readJson(path) {
  return JSON.parse(read(path));
}
