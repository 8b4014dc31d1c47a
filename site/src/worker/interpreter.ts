/**
 * Starts Pyodide from what the page handed over, without fetching anything.
 * May import `runtime/messages` (types) only.
 */
import type { PyodideAPI } from "pyodide";
import type { Boot } from "../runtime/messages.ts";
import type { LastWords } from "./last-words.ts";
import { bareGlobals, lockDown } from "./lockdown.ts";
import { sealBuiltins } from "./seal-python.ts";
import { Snapshot } from "./snapshot-pages.mjs";
import { WasmGate } from "./wasm-gate.ts";

const SITE_PACKAGES = "/lib/python3.14/site-packages";
const STDLIB_ARCHIVE = "/lib/python314.zip";

/** A program may use this much memory before Python's MemoryError; a tab has little more. */
const MEMORY_LIMIT_BYTES = 1024 * 1024 * 1024;

/** The end record of a zip archive, alone: an archive with nothing in it. */
const EMPTY_ZIP = Uint8Array.of(0x50, 0x4b, 5, 6, ...new Array<number>(18).fill(0));

/**
 * A helper module of 100 bytes that the loader makes for itself when it instantiates the
 * interpreter. We instantiate a module compiled once by the page, so we make it here:
 * `Jsv_GetError_import` returns a marker (an i31 reference), `JsvError_Check` recognises it.
 */
const ERROR_MARKER = Uint8Array.from(
  atob(
    "AGFzbQEAAAABDANfAGAAAW9gAW8BfwMDAgECBygCE0pzdl9HZXRFcnJvcl9pbXBvcnQAAA5Kc3ZFcnJvcl9DaGVjawABChMCBwD7AQD7GwsJACAA+xr7FAAL",
  ),
  (character) => character.charCodeAt(0),
);

/** Pyodide's settings object, as far as we touch it. */
interface Settings {
  instantiateWasm?: (
    imports: WebAssembly.Imports,
    done: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ) => object;
}

type Factory = (settings: Settings) => Promise<unknown>;
interface Loader {
  loadPyodide(config: Record<string, unknown>): Promise<PyodideAPI>;
}

/** A started interpreter; what it writes to its own error output goes to `lastWords`. */
export async function startInterpreter(boot: Boot, lastWords: LastWords): Promise<PyodideAPI> {
  console.error = (...parts: unknown[]) => lastWords.hear(parts.map(String).join(" "));
  answerFetchesFrom(boot);
  const [loader, factory] = await Promise.all([
    import(/* @vite-ignore */ `${boot.pyodideUrl}pyodide.mjs`) as Promise<Loader>,
    import(/* @vite-ignore */ `${boot.pyodideUrl}pyodide.asm.mjs`) as Promise<{ default: Factory }>,
  ]);
  const errorMarker = await makeErrorMarker();
  wasmGate.install();
  const snapshot = boot.snapshot && new Snapshot(await boot.snapshot.arrayBuffer());
  // The loader waits for an instance and has no ear for there being none.
  let noInstance: (error: unknown) => void = () => {};
  const failed = new Promise<never>((_, reject) => {
    noInstance = reject;
  });
  const loaded = loader.loadPyodide({
    indexURL: boot.pyodideUrl,
    env: { HOME: "/home/pyodide", PYTHONHASHSEED: "0" },
    jsglobals: bareGlobals(),
    // A program's own printing has been taken by bugbot before it comes here. The stack of a broken
    // interpreter comes on stdout, of all places.
    stdout: (text: string) => lastWords.hear(text),
    stderr: (text: string) => lastWords.hear(text),
    // Packages are unpacked by hand: the lock file would only be fetched and parsed for nothing.
    lockFileContents: { info: lockInfo(), packages: {} },
    ...(snapshot ? { _loadSnapshot: snapshot.forLoader() } : {}),
    createPyodideModule: (settings: Settings) => {
      settings.instantiateWasm = (imports, done) => {
        Object.assign(imports.env ?? {}, errorMarker);
        limitMemory(imports);
        WebAssembly.instantiate(boot.module, imports)
          .then((instance) => {
            snapshot?.begin(instance);
            done(instance, boot.module);
          })
          .catch(noInstance);
        return {};
      };
      return factory.default(settings);
    },
  });
  const pyodide = await Promise.race([loaded, failed]);
  for (const [path, bytes] of Object.entries(boot.sources)) {
    const target = `${SITE_PACKAGES}/${path}`;
    pyodide.FS.mkdirTree(target.slice(0, target.lastIndexOf("/")));
    pyodide.FS.writeFile(target, bytes, { canOwn: true });
  }
  return pyodide;
}

/**
 * Have a broken interpreter write its Python stack to its error output. Pyodide does so itself, but
 * when the stack of the engine is full there is no room left for the writing; here there is.
 */
export function writePythonStack(pyodide: PyodideAPI): void {
  const { _module } = pyodide as PyodideAPI & { _module?: { _dump_traceback?: () => void } };
  try {
    _module?._dump_traceback?.();
  } catch {
    // It is broken: what it has written is all there is.
  }
}

const wasmGate = new WasmGate();

const LOOK_EVERY_MS = 100;
const SIGINT = 2;
const realTime = performance.now.bind(performance);

/**
 * Have Python look at the clock now and then while a program computes. It asks this "buffer" again
 * and again whether Ctrl-C has been pressed, and `bugbot.run.watchdog` and `performer.patience` take each
 * press for a look.
 */
function lookAtTheClock(pyodide: PyodideAPI): void {
  let due = realTime() + LOOK_EVERY_MS;
  const presses = {
    get 0() {
      const now = realTime();
      if (now < due) return 0;
      due = now + LOOK_EVERY_MS;
      return SIGINT;
    },
    set 0(_taken: number) {},
  };
  pyodide.setInterruptBuffer(presses as unknown as Uint8Array);
}

/** `bridge.packages`, as far as it is called from here. */
interface Packages {
  unpack(archive: Uint8Array, folder: string): void;
  found_anew(): void;
}

/** An interpreter that may run a stranger's program, and what the worker can still do with it. */
export interface Sealed {
  /** One of our modules, imported if need be. */
  module(name: string): unknown;
  /** Puts the standard library's archive where the interpreter looks for it. */
  installStdlib(bytes: ArrayBuffer): void;
  installWheel(bytes: ArrayBuffer): void;
  /** From now on Python looks at the clock now and then. */
  lookAtTheClock(): void;
  /** Names on the global scope that could not be removed. */
  left: readonly string[];
}

/**
 * Closes every route out of a started interpreter. After this `pyodide.runPython` and the like don't
 * work: our own modules do everything.
 */
export function seal(pyodide: PyodideAPI, lastWords: LastWords): Sealed {
  const { import_module: module } = pyodide.pyimport("importlib") as {
    import_module(name: string): unknown;
  };
  const packages = module("bridge.packages") as Packages;
  (module("bridge.seal") as { seal(): void }).seal();
  sealBuiltins(pyodide);
  wasmGate.close();
  const left = lockDown((text) => lastWords.hear(text));
  return {
    module,
    installStdlib(bytes) {
      pyodide.FS.writeFile(STDLIB_ARCHIVE, new Uint8Array(bytes));
      // The snapshot has no directory of the archive, or that of the empty one.
      packages.found_anew();
    },
    installWheel(bytes) {
      packages.unpack(new Uint8Array(bytes), SITE_PACKAGES);
      for (const library of librariesBelow(pyodide, SITE_PACKAGES)) wasmGate.expect(library);
    },
    lookAtTheClock: () => lookAtTheClock(pyodide),
    left,
  };
}

/** The libraries in a folder and below it, as they are before a program runs. */
function* librariesBelow(pyodide: PyodideAPI, folder: string): Generator<Uint8Array> {
  for (const name of pyodide.FS.readdir(folder) as string[]) {
    if (name === "." || name === "..") continue;
    const path = `${folder}/${name}`;
    if (pyodide.FS.isDir(pyodide.FS.stat(path).mode)) yield* librariesBelow(pyodide, path);
    else if (name.endsWith(".so")) yield pyodide.FS.readFile(path) as Uint8Array;
  }
}

/** The loader asks for two files that we already have; nothing else gets an answer. */
function answerFetchesFrom(boot: Boot): void {
  self.fetch = (input: RequestInfo | URL) => {
    const url = input instanceof Request ? input.url : String(input);
    // Instantiated from the compiled module instead: this answer is never looked at.
    if (url.endsWith("pyodide.asm.wasm")) return new Promise(() => {});
    if (url.endsWith("python_stdlib.zip")) {
      return Promise.resolve(new Response(boot.stdlib ?? EMPTY_ZIP));
    }
    return Promise.reject(new Error(`A worker fetches nothing: ${url}`));
  };
}

async function makeErrorMarker(): Promise<WebAssembly.ModuleImports> {
  try {
    const { instance } = await WebAssembly.instantiate(ERROR_MARKER);
    return instance.exports as WebAssembly.ModuleImports;
  } catch {
    // Engines without garbage-collected references (older iOS) take any unique value.
    const marker = Symbol("error marker");
    return {
      Jsv_GetError_import: () => marker,
      JsvError_Check: (value: unknown) => (value === marker ? 1 : 0),
    };
  }
}

/** Refuse to grow beyond the limit, so that Python raises MemoryError before the tab dies. */
function limitMemory(imports: WebAssembly.Imports): void {
  const env = imports.env;
  const grow = env?.emscripten_resize_heap;
  if (!env || typeof grow !== "function") return;
  env.emscripten_resize_heap = (bytes: number) =>
    bytes >>> 0 > MEMORY_LIMIT_BYTES ? 0 : grow(bytes);
}

function lockInfo(): Record<string, string> {
  return {
    abi_version: "2026_0",
    arch: "wasm32",
    platform: "emscripten_5_0_3",
    version: "314.0.4",
    python: "3.14.0",
  };
}
