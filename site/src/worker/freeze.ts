/**
 * Freezes JavaScript's built-in objects, so that a program can neither plant a getter or setter in them
 * nor replace a function that other code calls. Imports nothing of ours.
 *
 * Freezing a prototype has a side effect: if `Error.prototype.name` is read-only, assigning `name` to an
 * error that inherits it fails too. Much code does that, Pyodide's included. So the properties of the
 * prototypes in question first become accessors whose setter defines the property on the object itself.
 */

/** Freezes these objects and everything that can be reached from them. */
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
    if (one === Error) freezeErrors();
    else Object.freeze(one);
  }
}

/** Pyodide sets `stackTraceLimit` for each error it makes, so that one property stays writable. */
function freezeErrors(): void {
  const { stackTraceLimit: value } = Error as { stackTraceLimit?: unknown };
  Object.defineProperty(Error, "stackTraceLimit", { value, writable: true, configurable: false });
  for (const key of Reflect.ownKeys(Error)) {
    if (key === "stackTraceLimit") continue;
    const property = Reflect.getOwnPropertyDescriptor(Error, key);
    const fixed = property && "value" in property ? { writable: false } : {};
    Reflect.defineProperty(Error, key, { ...fixed, configurable: false });
  }
  Object.preventExtensions(Error);
}

function isObject(value: unknown): value is object {
  return (typeof value === "object" && value !== null) || typeof value === "function";
}

/** Prototypes whose properties code assigns to on the objects that inherit them. */
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
          throw new TypeError(`${String(key)} can't be changed here`);
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

/** Built-in objects that no global name leads to; syntax or a call gives each of them. */
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
    // In some engines all errors share the functions that give them their stack.
    new Error("none"),
    ...iteratorHelpers(),
  ];
}

/** `Iterator` and the two kinds of object it makes, in engines that have it. */
function iteratorHelpers(): unknown[] {
  const { Iterator: Helper } = globalThis as {
    Iterator?: { from(iterator: object): { map(f: () => number): object } };
  };
  if (!Helper) return [];
  const wrapped = Helper.from({ next: () => ({ done: true, value: undefined }) });
  return [Helper, wrapped, wrapped.map(() => 0)];
}
