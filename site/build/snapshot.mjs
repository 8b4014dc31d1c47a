/**
 * Makes a memory snapshot of a started interpreter with our packages already imported.
 *
 * A worker that loads it is ready in about a tenth of the time of a plain start. The options with an
 * underscore are not public, which is why Pyodide's version is pinned exactly.
 */
import { join } from "node:path";
import { loadPyodide } from "pyodide";
import {
  growTo,
  memoryOf,
  packSnapshot,
  Snapshot,
  startOf,
} from "../src/worker/snapshot-pages.mjs";
import { ROOT } from "./files.mjs";

/**
 * Pyodide with the parts that are not public.
 * @typedef {import("pyodide").PyodideAPI & {
 *   makeMemorySnapshot(): Uint8Array,
 *   _module: {
 *     HEAPU8: Uint8Array,
 *     _malloc(bytes: number): number,
 *     _malloc_usable_size(block: number): number,
 *     _free(block: number): void,
 *     _sbrk(bytes: number): number,
 *   },
 * }} SnapshotMaker
 */

const SITE_PACKAGES = "/lib/python3.14/site-packages";

/** Standard modules that programs on the site use, so that no run waits for the library archive. */
const STANDARD_MODULES = [
  ..."array ast bisect calendar cmath collections collections.abc colorsys contextlib copy csv".split(
    " ",
  ),
  ..."dataclasses datetime decimal enum fractions functools heapq inspect io itertools json".split(
    " ",
  ),
  ..."linecache math numbers operator os pathlib pprint queue random re statistics string".split(
    " ",
  ),
  ..."struct sys textwrap time traceback types typing unicodedata warnings".split(" "),
];

/**
 * @param {Record<string, string>} sources path below site-packages -> text
 * @returns {Promise<Uint8Array<ArrayBuffer>>} its file: see `snapshot-pages.mjs`
 */
export async function makeSnapshot(sources) {
  /** @type {Uint8Array | null} */
  let fresh = null;
  const pyodide = /** @type {SnapshotMaker} */ (
    await withFreshInstance(
      (instance) => {
        fresh = new Uint8Array(memoryOf(instance).buffer).slice();
      },
      () => loadPyodide({ ...settings(), _makeSnapshot: true }),
    )
  );
  install(pyodide, sources);
  const modules = STANDARD_MODULES.concat(modulesOf(sources));
  pyodide.runPython(`
import importlib
importlib.invalidate_caches()
for _name in ${JSON.stringify(modules)}:
    importlib.import_module(_name)
del _name, importlib
`);
  zeroFreedMemory(pyodide);
  const snapshot = trimZeros(pyodide.makeMemorySnapshot());
  if (!fresh) throw new Error("Pyodide started without an instance that has a memory");
  const file = packSnapshot(snapshot, fresh, await memoryBeforeRestoring(snapshot));
  await prove(file, snapshot);
  return file;
}

/**
 * The memory of an interpreter in the moment a snapshot is put into its place.
 * @param {Uint8Array} snapshot as Pyodide makes it
 */
async function memoryBeforeRestoring(snapshot) {
  /** @type {Uint8Array | null} */
  let before = null;
  const given = snapshot.slice();
  /** @param {WebAssembly.Instance} instance */
  const begin = (instance) => growTo(memoryOf(instance), snapshot.length);
  await load(given, begin, (memory, take) => {
    before = memory.slice();
    return take();
  });
  if (!before) throw new Error("Pyodide has not taken the snapshot");
  return before;
}

/**
 * Starts an interpreter from the file and compares its memory with the snapshot's.
 * @param {Uint8Array<ArrayBuffer>} file
 * @param {Uint8Array} snapshot as Pyodide makes it
 */
async function prove(file, snapshot) {
  const wanted = snapshot.subarray(startOf(snapshot));
  let parting = Number.NaN;
  await startFrom(file, (memory, take) => {
    const nothing = take();
    parting = wanted.findIndex((byte, i) => byte !== memory[i]);
    return nothing;
  });
  if (parting !== -1) throw new Error(`the snapshot's file gives another memory at ${parting}`);
}

/**
 * @param {Uint8Array<ArrayBuffer>} file of a snapshot
 * @param {Taking} [taking]
 */
function startFrom(file, taking = (_memory, take) => take()) {
  const snapshot = new Snapshot(file.slice().buffer);
  return load(snapshot.forLoader(), (instance) => snapshot.begin(instance), taking);
}

/**
 * Called with an interpreter's memory in place of what takes the snapshot's memory out of it.
 * @typedef {(memory: Uint8Array, take: () => Uint8Array) => Uint8Array} Taking
 */

/**
 * @param {Uint8Array} snapshot for Pyodide
 * @param {(instance: WebAssembly.Instance) => void} begin before the interpreter starts
 * @param {Taking} taking
 */
function load(snapshot, begin, taking) {
  /** @type {WebAssembly.Memory | null} */
  let memory = null;
  const { subarray } = snapshot;
  Object.defineProperty(snapshot, "subarray", {
    /** @param {[number, number?]} range */
    value: (...range) => {
      const take = () => subarray.apply(snapshot, range);
      // The memory is what lies behind the notes: from somewhere to the end.
      return range.length === 1 && memory ? taking(new Uint8Array(memory.buffer), take) : take();
    },
  });
  return withFreshInstance(
    (fresh) => {
      memory = memoryOf(fresh);
      begin(fresh);
    },
    () => loadPyodide({ ...settings(), _loadSnapshot: snapshot }),
  );
}

/**
 * Starts something and hands over the instance of the interpreter in it as it is before it starts.
 * @template Started
 * @param {(instance: WebAssembly.Instance) => void} seen
 * @param {() => Promise<Started>} start
 * @returns {Promise<Started>}
 */
async function withFreshInstance(seen, start) {
  const instantiate = WebAssembly.instantiate;
  /** @param {[any, any]} given */
  const watched = async (...given) => {
    const made = await instantiate(...given);
    const instance = made instanceof WebAssembly.Instance ? made : made.instance;
    // The loader makes others of its own.
    if ("memory" in instance.exports) seen(instance);
    return made;
  };
  WebAssembly.instantiate = /** @type {typeof WebAssembly.instantiate} */ (watched);
  try {
    return await start();
  } finally {
    WebAssembly.instantiate = instantiate;
  }
}

/**
 * Not in the snapshot: NumPy can't be in one, PyYAML comes when a map is opened, and the command
 * line is not for the browser.
 */
const LEFT_OUT = /^import numpy|^import yaml|^import argparse|^from sandbox/m;

/**
 * Our modules, as names to import.
 * @param {Record<string, string>} sources
 */
function modulesOf(sources) {
  return Object.entries(sources)
    .filter(([path]) => path.endsWith(".py") && !path.includes("__main__"))
    .filter(([, text]) => !LEFT_OUT.test(text))
    .map(([path]) => path.replace(/(\/__init__)?\.py$/, "").replaceAll("/", "."));
}

/**
 * Run Python that returns a string in a plainly started interpreter that has the sources.
 * @param {Record<string, string>} sources
 * @param {string} code
 * @returns {Promise<string>}
 */
export async function runInPyodide(sources, code) {
  const pyodide = await loadPyodide(settings());
  install(pyodide, sources);
  pyodide.runPython("import importlib; importlib.invalidate_caches()");
  return pyodide.runPython(code);
}

/**
 * An interpreter started from such a snapshot's file, in Node.
 * @param {Uint8Array<ArrayBuffer>} file
 * @param {Record<string, string>} sources those in the snapshot, and more if need be
 */
export async function startFromSnapshot(file, sources) {
  const pyodide = await startFrom(file);
  install(pyodide, sources);
  pyodide.runPython("import importlib; importlib.invalidate_caches(); del importlib");
  return pyodide;
}

function settings() {
  return {
    // Pyodide guesses where it lies from a stack trace, which test runners rewrite.
    indexURL: join(ROOT, "node_modules/pyodide"),
    // Hash order is part of a run, so it is the same in every build.
    env: { HOME: "/home/pyodide", PYTHONHASHSEED: "0" },
  };
}

/**
 * @param {import("pyodide").PyodideAPI} pyodide
 * @param {Record<string, string>} sources
 */
function install(pyodide, sources) {
  for (const [path, text] of Object.entries(sources)) {
    const target = `${SITE_PACKAGES}/${path}`;
    pyodide.FS.mkdirTree(target.slice(0, target.lastIndexOf("/")));
    pyodide.FS.writeFile(target, text);
  }
}

/**
 * Overwrite memory that Python and the allocator have freed, so that it compresses away
 * (15 % of the download).
 * @param {SnapshotMaker} pyodide
 */
function zeroFreedMemory(pyodide) {
  pyodide.runPython(`
import gc, linecache, re
linecache.clearcache()
re.purge()
gc.collect()
def _fill_free_blocks():
    # Python's own allocator hands out blocks by size in steps of 16 bytes: take many of each
    # size, all zero, and let them go again.
    for size in range(0, 512, 16):
        taken = [bytes(size) for _ in range(4000)]
        del taken
_fill_free_blocks()
del _fill_free_blocks
gc.collect()
del gc, linecache, re
`);
  const module = pyodide._module;
  const taken = [];
  for (let size = 1 << 21; size >= 64; size >>= 1) {
    for (;;) {
      const end = module._sbrk(0);
      const block = module._malloc(size);
      if (block === 0) break;
      module.HEAPU8.fill(0, block, block + module._malloc_usable_size(block));
      taken.push(block);
      // The heap grew: no freed block of this size is left.
      if (module._sbrk(0) !== end) break;
    }
  }
  for (const block of taken) module._free(block);
}

/** @param {Uint8Array} bytes */
function trimZeros(bytes) {
  let end = bytes.length;
  while (end > 0 && bytes[end - 1] === 0) end -= 1;
  return bytes.slice(0, Math.ceil(end / 16) * 16);
}
