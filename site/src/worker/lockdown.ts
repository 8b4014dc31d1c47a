/**
 * Makes a worker's JavaScript powerless before a learner's program runs in it: of the global scope only
 * what is allowed by name is left, and all that is left is frozen.
 *
 * A program may come from a link that somebody sent, and Python's objects can lead to JavaScript's: so
 * nothing worth reaching is there. This is one of two fences; the frame's policy is the other
 * (`runtime/frame.ts`). Neither relies on the other.
 */
import { ALLOWED, ALLOWED_OF_WASM } from "./allowed.ts";
import { freezeAll } from "./freeze.ts";

/** What Pyodide itself looks up by name while programs run; everything else is out of sight. */
export function bareGlobals(): object {
  return Object.assign(Object.create(null), {
    setTimeout: (callback: () => void, ms: number) => setTimeout(callback, ms),
    clearTimeout: (id: number) => clearTimeout(id),
    Object: { fromEntries: Object.fromEntries },
  });
}

/**
 * For good. `hear` is told what the console is told.
 * @returns the names on the global scope, and along its prototypes, that are not allowed and could not be
 *   taken away: none in the engines we know
 */
export function lockDown(hear: (text: string) => void): string[] {
  const scope: object = globalThis;
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

/** Takes from a holder what is not allowed; what stays all the same becomes undefined if it can. */
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

/** A number or the like that is fixed: such as TEMPORARY, 0, which Chromium lets nobody remove. */
function isConstant(holder: object, key: PropertyKey): boolean {
  const property = Reflect.getOwnPropertyDescriptor(holder, key);
  return property?.writable === false && Object(property.value) !== property.value;
}

/** Small objects in the place of the browser's own, with just what Pyodide uses of them. */
function giveOurOwn(scope: object, hear: (text: string) => void): void {
  const { setTimeout, clearTimeout, performance, crypto } = globalThis;
  const { timeOrigin } = performance;
  const say = (...parts: unknown[]): void => hear(parts.map(String).join(" "));
  const own = {
    // A text would be carried out as code; and what is called is not told whose timer it was.
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

/** Every way from a function to `new Function`. */
function refuseCodeFromText(scope: object): void {
  const refuse = function refuse(): never {
    throw new TypeError("Making code from text is switched off here");
  };
  // Pyodide asks `x instanceof Function`, so the name must stay and keep its prototype.
  refuse.prototype = Function.prototype;
  Object.defineProperty(scope, "Function", { value: refuse, configurable: true });
  for (const kind of [() => {}, async () => {}, function* () {}, async function* () {}]) {
    const prototype = Object.getPrototypeOf(kind);
    Object.defineProperty(prototype, "constructor", { value: refuse, configurable: true });
  }
}
