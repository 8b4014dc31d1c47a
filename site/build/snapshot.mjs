/**
 * Makes a memory snapshot of a started interpreter with our packages already imported.
 *
 * A worker that loads it is ready in about a tenth of the time of a plain start. The options with an
 * underscore are not public, which is why Pyodide's version is pinned exactly.
 */
import { join } from "node:path";
import { loadPyodide } from "pyodide";
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

/** WebAssembly's memory grows by so much. */
const PAGE_BYTES = 65_536;

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
 * @returns {Promise<Uint8Array>} the memory, without the zeros at its end, as its difference from
 *   the memory of an interpreter that has not started. Whoever loads it has that memory too, so it
 *   need not be downloaded a second time (a quarter of the file).
 */
export async function makeSnapshot(sources) {
  /** @type {Uint8Array | null} */
  let fresh = null;
  const pyodide = /** @type {SnapshotMaker} */ (
    await withFreshMemory(
      (bytes) => {
        fresh = bytes.slice();
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
  differ(snapshot, fresh);
  return snapshot;
}

/**
 * Turns a snapshot's memory into its difference from a fresh one, in place, and back again.
 * `completeSnapshot` in the site's worker does the same.
 * @param {Uint8Array} snapshot
 * @param {Uint8Array} fresh
 */
function differ(snapshot, fresh) {
  // The second word says where the memory begins, behind what Pyodide notes about it.
  const start = new Uint32Array(snapshot.buffer, snapshot.byteOffset, 2)[1] ?? 0;
  const length = Math.min(snapshot.length - start, fresh.length);
  for (let i = 0; i < length; i += 1) {
    snapshot[start + i] = (snapshot[start + i] ?? 0) ^ (fresh[i] ?? 0);
  }
}

/**
 * Starts something and hands over the memory of the interpreter in it as it is before it starts.
 * @template Started
 * @param {(bytes: Uint8Array, memory: WebAssembly.Memory) => void} seen
 * @param {() => Promise<Started>} start
 * @returns {Promise<Started>}
 */
async function withFreshMemory(seen, start) {
  const instantiate = WebAssembly.instantiate;
  /** @param {[any, any]} given */
  const watched = async (...given) => {
    const made = await instantiate(...given);
    const instance = made instanceof WebAssembly.Instance ? made : made.instance;
    const { memory } = instance.exports;
    if (memory instanceof WebAssembly.Memory) seen(new Uint8Array(memory.buffer), memory);
    return made;
  };
  WebAssembly.instantiate = /** @type {typeof WebAssembly.instantiate} */ (watched);
  try {
    return await start();
  } finally {
    WebAssembly.instantiate = instantiate;
  }
}

/** Not in the snapshot: NumPy can't be in one, and the command line is not for the browser. */
const LEFT_OUT = /^import numpy|^import argparse/m;

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
 * An interpreter started from such a snapshot, in Node.
 * @param {Uint8Array} snapshot
 * @param {Record<string, string>} sources those in the snapshot, and more if need be
 */
export async function startFromSnapshot(snapshot, sources) {
  const complete = snapshot.slice();
  const pyodide = await withFreshMemory(
    (fresh, memory) => {
      differ(complete, fresh);
      const more = complete.length - fresh.length;
      if (more > 0) memory.grow(Math.ceil(more / PAGE_BYTES));
    },
    () => loadPyodide({ ...settings(), _loadSnapshot: complete }),
  );
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
