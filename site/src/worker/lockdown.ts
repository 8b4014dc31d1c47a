/**
 * Leaves JavaScript in a worker nothing to do harm with, before a learner's program runs there: only
 * the names in `allowed.ts` stay on the global scope, and everything that stays is frozen.
 *
 * A program may come from a link that somebody sent, and Python objects can lead to JavaScript. This
 * is one of two fences; the Content-Security-Policy is the other. Neither relies on the other.
 */
import { ALLOWED, ALLOWED_OF_WASM } from "./allowed.ts";
import { freezeAll } from "./freeze.ts";

/** The only names that Pyodide can look up on its `js` module while programs run. */
export function bareGlobals(): object {
  return Object.assign(Object.create(null), {
    setTimeout: (callback: () => void, ms: number) => setTimeout(callback, ms),
    clearTimeout: (id: number) => clearTimeout(id),
    Object: { fromEntries: Object.fromEntries },
  });
}

/**
 * Can't be undone.
 * @param hear gets whatever is written to the console
 * @returns names on the global scope and its prototypes that are not allowed but could not be removed:
 *   none in the engines we know
 */
export function lockDown(hear: (text: string) => void): string[] {
  const scope: object = globalThis;
  hearStrayErrors(hear);
  giveOurOwn(scope, hear);
  const left = removeAllBut(ALLOWED, scope);
  for (
    let above = Reflect.getPrototypeOf(scope);
    above !== null && above !== Object.prototype;
    above = Reflect.getPrototypeOf(above)
  ) {
    left.push(...removeAllBut(new Set(), above));
    Object.preventExtensions(above);
  }
  left.push(...removeAllBut(ALLOWED_OF_WASM, WebAssembly));
  refuseCodeFromText(scope);
  const kept = Reflect.ownKeys(scope).map((key) => Reflect.get(scope, key));
  freezeAll(kept.filter((value) => value !== scope));
  for (const key of Reflect.ownKeys(scope)) {
    Reflect.defineProperty(scope, key, { writable: false, configurable: false });
  }
  Reflect.preventExtensions(scope);
  return left;
}

/**
 * An error in a promise or a timer that a program has left behind would appear in the page's console, in
 * the program's own words. Node has no such events: there it ends the process.
 */
function hearStrayErrors(hear: (text: string) => void): void {
  if (typeof addEventListener !== "function") return;
  for (const kind of ["error", "unhandledrejection"]) {
    addEventListener(kind, (event) => {
      event.preventDefault();
      // We read nothing of the error itself: it may be an object that the program has made.
      hear("An error that nobody has caught");
    });
  }
}

/** Removes what is not allowed; returns the names of what could not be removed. */
function removeAllBut(allowed: ReadonlySet<string>, holder: object): string[] {
  const left = [];
  for (const key of Reflect.ownKeys(holder)) {
    if (typeof key === "string" && allowed.has(key)) continue;
    if (Reflect.deleteProperty(holder, key) || isConstant(holder, key)) continue;
    Reflect.defineProperty(holder, key, { value: undefined, writable: false });
    left.push(String(key));
  }
  return left;
}

/** A fixed number or text, such as `TEMPORARY` in Chromium, which can't be deleted and does no harm. */
function isConstant(holder: object, key: PropertyKey): boolean {
  const property = Reflect.getOwnPropertyDescriptor(holder, key);
  return property?.writable === false && Object(property.value) !== property.value;
}

/** Replaces objects of the browser by small ones with only the parts that Pyodide uses. */
function giveOurOwn(scope: object, hear: (text: string) => void): void {
  const { setTimeout, clearTimeout, performance, crypto } = globalThis;
  const { timeOrigin } = performance;
  const say = (...parts: unknown[]): void => hear(parts.map(String).join(" "));
  const own = {
    // The browser's would run a text as code, and call the function with the global scope as `this`.
    setTimeout: (callback: unknown, ms?: number, ...given: unknown[]) => {
      if (typeof callback !== "function") throw new TypeError("A timer calls a function");
      return setTimeout(() => callback(...given), ms);
    },
    clearTimeout: (id: number) => clearTimeout(id),
    performance: { now: () => performance.now(), timeOrigin },
    crypto: { getRandomValues: (bytes: Uint8Array<ArrayBuffer>) => crypto.getRandomValues(bytes) },
    console: { debug: say, error: say, info: say, log: say, trace: say, warn: say },
  };
  for (const [name, value] of Object.entries(own)) {
    Object.defineProperty(scope, name, { value, writable: true, configurable: true });
  }
}

/** Closes every way to make a function from text. */
function refuseCodeFromText(scope: object): void {
  const refuse = function refuse(): never {
    throw new TypeError("Making code from text is switched off here");
  };
  // Pyodide uses `x instanceof Function`, so the name must stay and keep its prototype.
  refuse.prototype = Function.prototype;
  Object.defineProperty(scope, "Function", { value: refuse, configurable: true });
  for (const kind of [() => {}, async () => {}, function* () {}, async function* () {}]) {
    const prototype = Object.getPrototypeOf(kind);
    Object.defineProperty(prototype, "constructor", { value: refuse, configurable: true });
  }
}
