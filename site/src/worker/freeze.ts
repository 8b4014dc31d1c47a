/**
 * Freezes everything that JavaScript's built-in objects are made of, so that no program can plant
 * a getter or a setter, or put a function of its own in the place of one that others call.
 * Imports nothing of ours.
 *
 * A frozen prototype has a catch: where `Error.prototype.name` can't be written, neither can the `name`
 * of an error that has none of its own yet. Code that does so is common, Pyodide's included. So the
 * properties of those prototypes that code writes over become pairs of functions first, of which
 * the second gives the object a property of its own.
 */

/** Everything that can be reached from these objects becomes fixed. */
export function freezeAll(roots: readonly unknown[]): void {
  for (const prototype of WRITTEN_OVER) keepWritableBelow(prototype);
  const waiting: unknown[] = [...roots, ...hiddenOnes()];
  const seen = new Set<object>();
  while (waiting.length > 0) {
    const one = waiting.pop();
    if (!isObject(one) || seen.has(one)) continue;
    seen.add(one);
    for (const key of Reflect.ownKeys(one)) {
      const property = Reflect.getOwnPropertyDescriptor(one, key);
      if (property) waiting.push(property.value, property.get, property.set);
    }
    waiting.push(Reflect.getPrototypeOf(one));
    Object.freeze(one);
  }
}

function isObject(value: unknown): value is object {
  return (typeof value === "object" && value !== null) || typeof value === "function";
}

/** Whose properties are written over on objects that inherit from them. */
const WRITTEN_OVER: readonly object[] = [
  Object.prototype,
  Function.prototype,
  ...[Error, EvalError, RangeError, ReferenceError, SyntaxError, TypeError, URIError].map(
    (kind) => kind.prototype,
  ),
];

function keepWritableBelow(prototype: object): void {
  for (const key of Reflect.ownKeys(prototype)) {
    const property = Reflect.getOwnPropertyDescriptor(prototype, key);
    if (!property?.configurable || !property.writable) continue;
    const { value, enumerable = false } = property;
    const pair = {
      get() {
        return value;
      },
      set(this: unknown, given: unknown) {
        if (!isObject(this) || this === prototype) {
          throw new TypeError(`${String(key)} is fixed here`);
        }
        const own = { value: given, writable: true, enumerable: true, configurable: true };
        if (!Reflect.defineProperty(this, key, own)) {
          throw new TypeError(`${String(key)} can't be written here`);
        }
      },
    };
    Object.defineProperty(prototype, key, { ...pair, enumerable, configurable: false });
  }
}

/** Built-in objects that no name leads to; each is had from something that is written. */
function hiddenOnes(): unknown[] {
  const functions = [() => {}, async () => {}, function* () {}, async function* () {}];
  const text = "text";
  return [
    ...functions,
    ...functions.map((one) => one.prototype),
    [].values(),
    new Map().entries(),
    new Set().values(),
    text[Symbol.iterator](),
    text.matchAll(/x/g),
    Promise.resolve(),
    // In some engines an error has its stack by functions that all errors share.
    new Error("none"),
    ...iteratorHelpers(),
  ];
}

/** `Iterator` and the two kinds of objects that it makes, in engines that have it. */
function iteratorHelpers(): unknown[] {
  const { Iterator: Helper } = globalThis as {
    Iterator?: { from(iterator: object): { map(f: () => number): object } };
  };
  if (!Helper) return [];
  const wrapped = Helper.from({ next: () => ({ done: true, value: undefined }) });
  return [Helper, wrapped, wrapped.map(() => 0)];
}
