/**
 * The names that stay on a worker's global scope once Python has started: the language itself, and
 * the few parts of the browser that Pyodide looks up while programs run. Everything else is removed,
 * so a feature that an engine adds later is removed too. Imports nothing of ours.
 *
 * Before you add a name, ask what a stranger's program could do with it and with everything that can
 * be reached from it.
 */

/** ECMAScript. `Function` is replaced by one that refuses; `eval` and `Intl` are not needed. */
const LANGUAGE = [
  ..."globalThis undefined NaN Infinity isFinite isNaN parseFloat parseInt".split(" "),
  ..."decodeURI decodeURIComponent encodeURI encodeURIComponent".split(" "),
  ..."Object Function Boolean Symbol Number BigInt Math Date String RegExp JSON".split(" "),
  ..."Error AggregateError EvalError RangeError ReferenceError SyntaxError TypeError".split(" "),
  ..."URIError SuppressedError InternalError".split(" "),
  ..."Array Map Set WeakMap WeakSet WeakRef FinalizationRegistry Promise Proxy Reflect".split(" "),
  ..."ArrayBuffer SharedArrayBuffer DataView Atomics Int8Array Uint8Array".split(" "),
  ..."Uint8ClampedArray Int16Array Uint16Array Int32Array Uint32Array BigInt64Array".split(" "),
  ..."BigUint64Array Float16Array Float32Array Float64Array".split(" "),
  "WebAssembly",
];

/**
 * Parts of the browser. `lockdown.ts` replaces all but the text coders with small objects of our
 * own: the browser's `performance`, for example, lists every file that was loaded.
 */
const BROWSER = [
  ..."console crypto performance setTimeout clearTimeout TextDecoder TextEncoder".split(" "),
];

export const ALLOWED: ReadonlySet<string> = new Set([...LANGUAGE, ...BROWSER]);

/**
 * Members of WebAssembly. Nothing here compiles bytes except `Module`, which `wasm-gate.ts` replaces by
 * one that only takes bytes it knows.
 */
export const ALLOWED_OF_WASM: ReadonlySet<string> = new Set(
  (
    "Module Instance Memory Table Global Tag JSTag Exception Function Suspending SuspendError promising " +
    "CompileError LinkError RuntimeError"
  ).split(" "),
);
