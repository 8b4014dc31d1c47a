/**
 * Takes away from a worker what a learner's program has no business with: network, storage, other
 * workers, code made from text, and messages that pose as ours.
 *
 * A program may come from a link that somebody sent, and Python's objects lead to JavaScript's.
 * This is one of two fences; the Content-Security-Policy is the other. Neither relies on the other.
 * Imports nothing of ours.
 */

/** Globals of a worker that reach beyond it. Missing ones do no harm. */
const FORBIDDEN = [
  // network
  "fetch",
  "fetchLater",
  "XMLHttpRequest",
  "WebSocket",
  "WebSocketStream",
  "EventSource",
  "WebTransport",
  "RTCPeerConnection",
  "Request",
  "importScripts",
  // storage
  "indexedDB",
  "webkitIndexedDB",
  "caches",
  "cookieStore",
  "FileReaderSync",
  "StorageManager",
  // other contexts
  "Worker",
  "SharedWorker",
  "BroadcastChannel",
  "MessageChannel",
  "navigator",
  "Notification",
  "postMessage",
  "close",
  "onmessage",
  "onmessageerror",
  "addEventListener",
  "dispatchEvent",
  "location",
  // code from text
  "eval",
];

/** What Pyodide itself looks up by name while programs run; everything else is out of sight. */
export function bareGlobals(): object {
  return Object.assign(Object.create(null), {
    setTimeout: (callback: () => void, ms: number) => setTimeout(callback, ms),
    clearTimeout: (id: number) => clearTimeout(id),
    Object: { fromEntries: Object.fromEntries },
  });
}

/** Remove the forbidden globals and every way from a function to `new Function`. For good. */
export function lockDown(): void {
  for (const name of FORBIDDEN) {
    for (let holder: object | null = self; holder; holder = Object.getPrototypeOf(holder)) {
      Reflect.deleteProperty(holder, name);
    }
    Reflect.defineProperty(self, name, { value: undefined, writable: false, configurable: false });
  }

  // Pyodide asks `x instanceof Function`, so the name must stay and keep its prototype.
  const refuse = function refuse(): never {
    throw new TypeError("Making code from text is switched off here");
  };
  refuse.prototype = Function.prototype;
  Object.defineProperty(self, "Function", {
    value: refuse,
    writable: false,
    configurable: false,
  });
  const kinds = [() => {}, async () => {}, function* () {}, async function* () {}];
  for (const kind of kinds) {
    Object.defineProperty(Object.getPrototypeOf(kind), "constructor", {
      value: refuse,
      writable: false,
      configurable: false,
    });
  }
}

/** Python run once after loading: the modules that lead to JavaScript can't be imported any more. */
export const CLOSE_IMPORTS = `
import sys
from _pyodide._importhook import jsfinder
jsfinder.jsproxies.clear()
for _name in list(sys.modules):
    if _name.partition(".")[0] in ("js", "pyodide_js"):
        del sys.modules[_name]
del _name, jsfinder, sys
`;
