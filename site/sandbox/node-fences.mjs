/**
 * What Node itself gives a program and a learner's must not have: the network, the process, the
 * console. Node's permission model (see site/build/sandbox.mjs for the options) closes files, other
 * processes, threads and add-ons; before Node 25 it knows nothing of the network, so that is done here.
 *
 * Not a fence by itself: without code made from text, Python has no road to any of this. It is there
 * for the road that nobody has thought of. Imports Node's own modules only.
 */
import dgram from "node:dgram";
import dns from "node:dns";
import { syncBuiltinESMExports } from "node:module";
import net from "node:net";

/** Globals of Node that lead out of the interpreter. */
const NODE_GLOBALS = ["process", "global", "Buffer", "setImmediate", "clearImmediate"];

/**
 * What is left of `process`: what Node itself looks up on it while a program runs. All else goes, `kill`,
 * `getBuiltinModule`, `binding`, `dlopen`, `env` and whatever a later Node brings among it.
 */
const KEPT_OF_PROCESS = new Set([
  ..."version versions platform arch release features title pid".split(" "),
  ..."nextTick emitWarning emit on once off addListener removeListener listenerCount".split(" "),
  ..."exit exitCode reallyExit _exiting _events _eventsCount _maxListeners _tickCallback".split(
    " ",
  ),
]);

/**
 * What Node asks of `process` though it may not be there: where it is, no getter that a program has
 * planted further up is asked.
 */
const ASKED_OF_PROCESS = {
  env: Object.freeze(Object.create(null)),
  noDeprecation: true,
  throwDeprecation: false,
  traceDeprecation: false,
  traceProcessWarnings: false,
  domain: null,
};

/** @returns {never} */
function refuse() {
  throw new Error("There is no network here");
}

/** Every connection, name look-up and listening socket of this process fails from now on. */
export function closeNetwork() {
  /** @type {[object, string[]][]} */
  const roads = [
    [net, ["connect", "createConnection", "createServer"]],
    [net.Socket.prototype, ["connect"]],
    [net.Server.prototype, ["listen"]],
    [dgram, ["createSocket"]],
    [dgram.Socket.prototype, ["bind", "connect", "send"]],
    [dns.Resolver.prototype, functionsOf(dns.Resolver.prototype)],
    [dns.promises, functionsOf(dns.promises)],
    [dns, functionsOf(dns)],
  ];
  for (const [holder, names] of roads) {
    for (const name of names) {
      // What is a getter or fixed already is left as it is.
      const { writable } = Object.getOwnPropertyDescriptor(holder, name) ?? {};
      if (writable) Object.defineProperty(holder, name, { value: refuse, writable: false });
    }
  }
  // Node's own modules hold on to what they have taken from each other; this is for `import`.
  syncBuiltinESMExports();
}

/**
 * Takes away Node's globals, and gives `console` to `hear`: standard output belongs to the results.
 * @param {(text: string) => void} hear
 */
export function closeGlobals(hear) {
  const { process } = globalThis;
  for (const name of Reflect.ownKeys(process)) {
    if (typeof name !== "string" || KEPT_OF_PROCESS.has(name)) continue;
    // What can't be deleted is made undefined; what can't be that either is a plain value.
    if (Reflect.deleteProperty(process, name)) continue;
    Reflect.defineProperty(process, name, { value: undefined, writable: false });
  }
  for (const [name, value] of Object.entries(ASKED_OF_PROCESS)) {
    Object.defineProperty(process, name, { value, writable: false, configurable: false });
  }
  for (const name of NODE_GLOBALS) Reflect.deleteProperty(globalThis, name);
  const say = (/** @type {unknown[]} */ ...parts) => hear(parts.map(String).join(" "));
  const quiet = { debug: say, error: say, info: say, log: say, trace: say, warn: say };
  Object.defineProperty(globalThis, "console", { value: quiet, writable: true });
}

/** @param {object} holder */
function functionsOf(holder) {
  return Object.getOwnPropertyNames(holder).filter(
    (name) =>
      name !== "constructor" &&
      typeof Object.getOwnPropertyDescriptor(holder, name)?.value === "function",
  );
}
