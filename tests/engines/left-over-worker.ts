/**
 * A worker that locks itself down as the site's workers do and reports what is left. `left-over.mjs`
 * bundles it and starts it in each engine.
 */
import { lockDown } from "../../site/src/worker/lockdown.ts";

const say = self.postMessage.bind(self);
const notAllowed = lockDown(() => {});

/** Everything that can be reached from the global scope by properties and prototypes. */
const seen = new Map<object, string>();
const waiting: [unknown, string][] = [[globalThis, "globalThis"]];
for (const kind of [() => {}, async () => {}, function* () {}, async function* () {}]) {
  waiting.push([Object.getPrototypeOf(kind), `a kind of function: ${kind}`]);
}
waiting.push([[].values(), "an iterator"], [/x/, "a pattern"], [new Error("x"), "an error"]);
for (let next = waiting.pop(); next; next = waiting.pop()) {
  const [one, path] = next;
  if ((typeof one !== "object" && typeof one !== "function") || one === null) continue;
  if (seen.has(one)) continue;
  seen.set(one, path);
  waiting.push([Object.getPrototypeOf(one), `${path}.__proto__`]);
  for (const key of Reflect.ownKeys(one)) {
    const { value, get, set } = Reflect.getOwnPropertyDescriptor(one, key) ?? {};
    const name = `${path}.${String(key)}`;
    waiting.push([value, name], [get, `get ${name}`], [set, `set ${name}`]);
  }
}
const shared = [...seen].filter(([, path]) => !/^(an iterator|a pattern|an error)$/.test(path));
say({
  notAllowed,
  names: Reflect.ownKeys(globalThis).map(String).sort(),
  above: namesAbove(),
  notFrozen: shared
    .filter(([one]) => one !== globalThis && !Object.isFrozen(one))
    .flatMap(([one, path]) =>
      changeable(one).map((what) => (one === Error ? "Error" : path) + what),
    ),
  extensible: Object.isExtensible(globalThis),
  writable: Reflect.ownKeys(globalThis)
    .filter((key) => Reflect.getOwnPropertyDescriptor(globalThis, key)?.writable)
    .map(String),
});

function changeable(one: object): string[] {
  const names = Reflect.ownKeys(one).filter((key) => {
    const property = Reflect.getOwnPropertyDescriptor(one, key);
    return property?.configurable || property?.writable;
  });
  const more = Object.isExtensible(one) ? [", to which names can be added,"] : [];
  return [...names.map((name) => `.${String(name)}`), ...more];
}

function namesAbove(): string[] {
  const names: string[] = [];
  let above: object | null = Reflect.getPrototypeOf(globalThis);
  while (above && above !== Object.prototype) {
    for (const key of Reflect.ownKeys(above)) {
      const property = Reflect.getOwnPropertyDescriptor(above, key);
      // A fixed number does no harm.
      const constant = property?.writable === false && Object(property.value) !== property.value;
      if (!constant) names.push(String(key));
    }
    above = Reflect.getPrototypeOf(above);
  }
  return names;
}
