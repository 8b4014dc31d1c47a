/**
 * Makes a memory snapshot of a started interpreter with our packages already imported.
 *
 * A worker that loads it is ready in about a tenth of the time of a plain start. The options with an
 * underscore are not public, which is why Pyodide's version is pinned exactly.
 */
import { loadPyodide } from "pyodide";

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
 * @returns {Promise<Uint8Array>} the memory, without the zeros at its end
 */
export async function makeSnapshot(sources) {
  const pyodide = /** @type {SnapshotMaker} */ (
    await loadPyodide({ _makeSnapshot: true, env: environment() })
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
  const memory = pyodide.makeMemorySnapshot();
  return trimZeros(memory);
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
  const pyodide = await loadPyodide({ env: environment() });
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
  const pyodide = await loadPyodide({ env: environment(), _loadSnapshot: snapshot });
  install(pyodide, sources);
  pyodide.runPython("import importlib; importlib.invalidate_caches(); del importlib");
  return pyodide;
}

/** Hash order is part of a run, so it is the same in every build. */
function environment() {
  return { HOME: "/home/pyodide", PYTHONHASHSEED: "0" };
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
