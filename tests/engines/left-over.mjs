/** Lists what a worker's global scope holds after the lock-down, and compares it with what is allowed. */
import { join } from "node:path";
import { ROOT } from "../../site/build/files.mjs";
import { standalone } from "../../site/build/standalone.mjs";

/**
 * @typedef {object} LeftOver
 * @property {string[]} notAllowed names that could not be removed
 * @property {string[]} names on the global scope
 * @property {string[]} above along its prototypes, up to Object's
 * @property {string[]} notFrozen paths to what could still be changed
 * @property {boolean} extensible whether the global scope takes new names
 * @property {string[]} writable names on it that could be given another value
 */

/** Pyodide sets it for each error; whatever a program writes there is only a number of lines. */
const STAYS_WRITABLE = "Error.stackTraceLimit";

/** JavaScript to run in a page: its value is a promise of a LeftOver. */
export async function lookingAtLeftOver() {
  const script = await standalone(join(ROOT, "tests/engines/left-over-worker.ts"));
  return `new Promise((resolve, reject) => {
    const script = new Blob([${JSON.stringify(script)}], { type: "text/javascript" });
    const worker = new Worker(URL.createObjectURL(script));
    worker.onerror = (event) => reject(new Error(event.message));
    worker.onmessage = (event) => { resolve(event.data); worker.terminate(); };
  })`;
}

/**
 * What is wrong, in words. Empty if all is well.
 * @param {LeftOver} left
 * @param {ReadonlySet<string>} allowed
 */
export function faultsOf(left, allowed) {
  const strange = left.names.filter((name) => !allowed.has(name));
  return [
    ...strange.map((name) => `${name} is new, and not allowed`),
    ...left.notAllowed.map((name) => `${name} could not be removed`),
    ...left.above.map((name) => `${name} is left on a prototype`),
    ...left.notFrozen
      .filter((path) => path !== STAYS_WRITABLE)
      .map((path) => `${path} can be changed`),
    ...left.writable.map((name) => `${name} can be given another value`),
    ...(left.extensible ? ["the global scope takes new names"] : []),
  ];
}
