/**
 * Prepares the locked-down Python that marks files nobody vouches for, under .cache/sandbox/, and
 * tells how it is started: node site/build/sandbox.mjs prints, as its last line,
 * {"command": [node, options…, script], "folder": …} as JSON. `sandbox.node` reads that.
 *
 * The folder holds a bundle of site/sandbox/performer.ts and, unpacked, all that it reads; the process
 * may read that folder, and nothing else of this machine.
 */
import { cpSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { gunzipSync } from "node:zlib";
import {
  CACHE,
  filesBelow,
  hashOfFiles,
  messageOf,
  preparedFolder,
  ROOT,
  sha256,
  write,
} from "./files.mjs";
import { ensureInstalled, fail } from "./install.mjs";

const HOME = join(CACHE, "sandbox");

/** Megabytes of JavaScript objects in one process; Python's own memory is bounded by the worker. */
const JS_HEAP_MB = 512;

export async function prepareSandbox() {
  ensureInstalled();
  const { preparePython } = await import("./python.mjs");
  const { folder: python, manifest } = await preparePython((text) => console.error(text));
  const scripts = [
    ...filesBelow(join(ROOT, "site/sandbox")).map((path) => join(ROOT, "site/sandbox", path)),
    ...filesBelow(join(ROOT, "site/src/worker")).map((path) => join(ROOT, "site/src/worker", path)),
    join(ROOT, "site/build/sandbox.mjs"),
  ];
  const key = sha256(manifest.key + hashOfFiles(scripts)).slice(0, 16);
  const folder = await preparedFolder(HOME, key, (draft) => make(draft, python, manifest));
  return { command: [process.execPath, ...options(folder), join(folder, "performer.mjs")], folder };
}

/**
 * @param {string} draft the folder to write
 * @param {string} python
 * @param {import("./python.mjs").Manifest} manifest
 */
async function make(draft, python, manifest) {
  console.error("preparing the locked-down Python for marking");
  await bundle(join(ROOT, "site/sandbox/performer.ts"), draft, "performer.mjs");
  /** @param {string} name */
  const stored = (name) => readFileSync(join(python, manifest.files[name]?.path ?? name));
  write(join(draft, "interpreter.wasm"), gunzipSync(stored("interpreter")));
  write(join(draft, "snapshot.bin"), gunzipSync(stored("snapshot")));
  write(join(draft, "stdlib.zip"), stored("stdlib"));
  write(join(draft, "numpy.whl"), stored("numpy"));
  cpSync(join(python, manifest.loader), join(draft, "loader"), { recursive: true });
}

/**
 * One script with all that it imports.
 * @param {string} entry
 * @param {string} outDir
 * @param {string} name
 */
export async function bundle(entry, outDir, name) {
  const { build } = await import("vite");
  await build({
    configFile: false,
    logLevel: "warn",
    root: join(ROOT, "site"),
    publicDir: false,
    build: {
      ssr: entry,
      outDir,
      emptyOutDir: false,
      target: "es2022",
      rollupOptions: { output: { entryFileNames: name } },
    },
  });
}

/** What Node is told to refuse. @param {string} folder */
export function options(folder) {
  const [major = 0, minor = 0] = process.versions.node.split(".").map(Number);
  const stable = major >= 24 || (major === 23 && minor >= 5) || (major === 22 && minor >= 13);
  return [
    stable ? "--permission" : "--experimental-permission",
    `--allow-fs-read=${join(folder, "*")}`,
    "--disallow-code-generation-from-strings",
    // --frozen-intrinsics does not hold with Pyodide, which adds to JavaScript's own functions while it
    // starts; the worker's lock-down freezes them afterwards.
    "--disable-proto=delete",
    "--no-addons",
    "--no-warnings",
    `--max-old-space-size=${JS_HEAP_MB}`,
    // Optimise what runs for long, not all that a start passes through: a quarter less computing.
    "--wasm-tiering-budget=20000000",
  ];
}

if (process.argv[1] === import.meta.filename) {
  try {
    console.log(JSON.stringify(await prepareSandbox()));
  } catch (error) {
    fail(`The locked-down Python could not be prepared.\n${messageOf(error)}`);
  }
}
