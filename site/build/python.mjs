/**
 * Prepares everything the browser needs to run Python, under .cache/python/:
 * the interpreter, its memory snapshot, the standard library, NumPy, PyYAML, our sources, and what
 * the page knows about them (manifest.json, course.json). Made again only when something changed.
 *
 * Large files are stored gzipped under names that end in .bin, so that they are small on any static
 * host and no server unpacks them on the way; the page does that itself.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { promisify } from "node:util";
import * as zlib from "node:zlib";
import { CACHE, filesBelow, hashOfFiles, preparedFolder, ROOT, sha256, write } from "./files.mjs";
import { numpyWheel } from "./numpy.mjs";
import { runInThread } from "./python-once.mjs";
import { pyyamlArchive } from "./pyyaml.mjs";
import { makeSnapshot } from "./snapshot.mjs";
import { zip } from "./zip.mjs";

/** In a thread of Node's own. @param {string | Uint8Array} data */
const gzip = (data) => promisify(zlib.gzip)(data, { level: 9 });

const PYODIDE = join(ROOT, "node_modules/pyodide");
/** One folder for each state of what goes in. */
const READY = join(CACHE, "python");

/** Packages under py/ that go to the browser. */
const PACKAGES = ["bugbot", "performer", "mapping", "grader", "bridge"];

/** What stays behind: marking a class's files and changing solutions is for an author's machine. */
const STAYS = /^(classes|mutants)\//;

/**
 * What would tell a program what is right. No interpreter that runs one has it, so it is neither in the
 * snapshot nor among the sources: an archive brings it to the workers that judge or convert.
 */
const JUDGING = /^(grader|mapping)\/|^bridge\/(judging|ros|map_files)\.py$/;

/**
 * Python run at build time: the modules at PATHS compiled as this interpreter would, as base64 by path; and
 * the robot's calls as data, from their own docstrings.
 */
const COMPILE_AND_DESCRIBE = `
import base64, json, py_compile
site = "/lib/python3.14/site-packages"
compiled = {}
for path in PATHS:
    made = py_compile.compile(f"{site}/{path}", "/tmp/made.pyc", path, doraise=True,
        invalidation_mode=py_compile.PycInvalidationMode.UNCHECKED_HASH)
    with open(made, "rb") as file:
        compiled[path + "c"] = base64.b64encode(file.read()).decode()
from bridge.describe import describe
json.dumps({"compiled": compiled, "course": describe()}, ensure_ascii=False)
`;

/**
 * @typedef {{ path: string, bytes: number }} PythonFile
 * @typedef {{
 *   key: string,
 *   pyodide: string,
 *   numpy: string,
 *   loader: string,
 *   files: Record<string, PythonFile>,
 * }} Manifest
 * @typedef {{
 *   worlds: object[], api: import("./calls-page.mjs").Call[],
 *   groups: import("./calls-page.mjs").Group[],
 * }} Course
 *
 * @param {(text: string) => void} log
 * @returns {Promise<{ folder: string, manifest: Manifest, course: Course }>}
 */
export async function preparePython(log = (_text) => {}) {
  const sources = readSources();
  const key = inputsKey();
  const folder = await preparedFolder(READY, key, (draft) => prepareInto(draft, key, sources, log));
  /** @param {string} name */
  const read = (name) => JSON.parse(readFileSync(join(folder, name), "utf8"));
  return { folder, manifest: read("manifest.json"), course: read("course.json") };
}

/**
 * @param {string} folder to be written
 * @param {string} key
 * @param {Record<string, string>} sources
 * @param {(text: string) => void} log
 */
async function prepareInto(folder, key, sources, log) {
  log("preparing Python for the browser: interpreter, snapshot, NumPy, PyYAML");
  const held = Object.fromEntries(Object.entries(sources).filter(([path]) => !JUDGING.test(path)));
  const judging = Object.keys(sources).filter((path) => JUDGING.test(path));
  const toCompile = JSON.stringify(judging.filter((path) => path.endsWith(".py")));
  // Side by side: both of the first two keep a core busy for seconds.
  const [described, { wheel, yaml, snapshot }, interpreter] = await Promise.all([
    runInThread(sources, COMPILE_AND_DESCRIBE.replace("PATHS", toCompile)),
    fetchedAndStarted(held, log),
    gzip(readFileSync(join(PYODIDE, "pyodide.asm.wasm"))),
  ]);
  const { compiled, course } = JSON.parse(described);

  const manifest = /** @type {Manifest} */ ({
    key,
    pyodide: JSON.parse(readFileSync(join(PYODIDE, "package.json"), "utf8")).version,
    numpy: wheel.version,
    files: {
      interpreter: store(folder, "interpreter", interpreter),
      snapshot: store(folder, "snapshot", await gzip(snapshot)),
      sources: store(folder, "sources", await gzip(JSON.stringify(held))),
      // Archives are compressed already.
      stdlib: store(folder, "stdlib", readFileSync(join(PYODIDE, "python_stdlib.zip"))),
      numpy: store(folder, "numpy", wheel.bytes),
      yaml: store(folder, "yaml", yaml),
      judging: store(folder, "judging", archiveOf(compiled)),
    },
    loader: `pyodide-${sha256(readFileSync(join(PYODIDE, "pyodide.asm.mjs"))).slice(0, 8)}`,
  });
  for (const file of ["pyodide.mjs", "pyodide.asm.mjs"]) {
    write(join(folder, manifest.loader, file), readFileSync(join(PYODIDE, file)));
  }
  write(join(folder, "course.json"), JSON.stringify(course));
  write(join(folder, "manifest.json"), JSON.stringify(manifest, null, 2));
}

/**
 * The packages from elsewhere, and the snapshot with our own sources in it.
 * @param {Record<string, string>} sources
 * @param {(text: string) => void} log
 */
async function fetchedAndStarted(sources, log) {
  const wheel = await numpyWheel(log);
  const yaml = pyyamlArchive(log);
  return { wheel, yaml, snapshot: await makeSnapshot(sources) };
}

/**
 * An archive of compiled modules: a worker that has it imports them in a third of the time.
 * @param {Record<string, string>} compiled base64 by path
 */
function archiveOf(compiled) {
  return zip(
    Object.entries(compiled).map(([path, text]) => ({ path, data: Buffer.from(text, "base64") })),
  );
}

function readSources() {
  /** @type {Record<string, string>} */
  const sources = {};
  for (const name of PACKAGES) {
    const folder = join(ROOT, "py", name);
    for (const path of filesBelow(
      folder,
      (file) => /\.(py|json)$/.test(file) && !STAYS.test(file),
    )) {
      sources[`${name}/${path}`] = readFileSync(join(folder, path), "utf8");
    }
  }
  return sources;
}

function inputsKey() {
  const ours = PACKAGES.flatMap((name) =>
    filesBelow(join(ROOT, "py", name), (file) => !STAYS.test(file)).map((path) =>
      join(ROOT, "py", name, path),
    ),
  );
  const build = ["files", "numpy", "python", "python-once", "pyyaml", "snapshot", "zip"].map(
    (name) => join(ROOT, "site/build", `${name}.mjs`),
  );
  const pages = join(ROOT, "site/src/worker/snapshot-pages.mjs");
  return hashOfFiles([...ours, ...build, pages, join(PYODIDE, "package.json")]);
}

/**
 * @param {string} folder
 * @param {string} name
 * @param {Uint8Array} bytes
 * @returns {PythonFile}
 */
function store(folder, name, bytes) {
  const path = `${name}-${sha256(bytes).slice(0, 8)}.bin`;
  write(join(folder, path), bytes);
  return { path, bytes: bytes.length };
}
