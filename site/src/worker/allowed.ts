/**
 * What a worker's global scope may still hold once Python has started: the language itself, and the
 * few things of the browser that Pyodide looks up while programs run. Whatever is not named here is
 * taken away, so something new in an engine is closed before anybody has heard of it.
 * Imports nothing of ours.
 *
 * Before you add a name, ask what a stranger's program could do with it, and with all that can be
 * reached from it.
 */

/** ECMAScript. `Function` stands for one that refuses; `eval` and Intl are not needed. */
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
 * Of the browser. `lockdown` puts small objects of our own in the place of most: the browser's
 * `performance`, say, knows every file that was loaded.
 */
const BROWSER = [
  ..."console crypto performance setTimeout clearTimeout TextDecoder TextEncoder".split(" "),
];

export const ALLOWED: ReadonlySet<string> = new Set([...LANGUAGE, ...BROWSER]);

/**
 * Of WebAssembly, without what makes modules out of bytes: `Module` stays, behind a gate that knows
 * which bytes are ours (`wasm-gate.ts`).
 */
export const ALLOWED_OF_WASM: ReadonlySet<string> = new Set(
  (
    "Module Instance Memory Table Global Tag JSTag Exception Function Suspending SuspendError promising " +
    "CompileError LinkError RuntimeError"
  ).split(" "),
);
