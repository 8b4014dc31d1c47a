/** Getters and functions planted in JavaScript's own objects. */
import { OBJECT } from "./tools.mjs";

/** @typedef {import("./tools.mjs").Kind} Kind */

/** @type {Kind} */
export const PLANTING_IN_JAVASCRIPTS_OWN_OBJECTS = {
  kind: "planting in JavaScript's own objects",
  ways: [
    {
      name: "a getter on Object.prototype",
      program: `${OBJECT}
O = js_object()
for plant in ("__defineGetter__", "__defineSetter__"):
    try:
        getattr(O.prototype, plant)("devicePixelRatio", print)
    except Exception as error:
        print("closed", type(error).__name__)
print("OPEN" if O.prototype.hasOwnProperty("devicePixelRatio") else "closed")`,
    },
    {
      name: "functions of Array, Promise, Function and JSON",
      program: `${OBJECT}
O = js_object()
A = O.keys(O).constructor
for holder, name in ((A.prototype, "push"), (A.prototype, "join"), (A, "from"), (O, "keys"), (O.prototype, "toString"), (O.keys, "call"), (O.keys.__proto__, "apply")):
    before = getattr(holder, name)
    try:
        setattr(holder, name, print)
    except Exception as error:
        print("closed", type(error).__name__)
    if holder is not O.keys and getattr(holder, name).js_id != before.js_id: print("OPEN", name)`,
    },
    {
      name: "symbols: iterators, species, conversion",
      program: `${OBJECT}
O = js_object()
A = O.keys(O).constructor
for symbol in O.getOwnPropertySymbols(A.prototype):
    try:
        O.defineProperty(A.prototype, symbol, O.fromEntries([["value", print]]))
        print("OPEN", str(symbol))
    except Exception as error:
        print("closed", type(error).__name__)`,
    },
    {
      name: "hidden prototypes: iterators, generators, typed arrays",
      program: `${OBJECT}
O = js_object()
A = O.keys(O)
iterator = A.values()
one = iterator
for step in range(3):
    one = O.getPrototypeOf(one)
    print("OPEN" if O.isExtensible(one) else "closed", str(one)[:40])`,
    },
    {
      name: "how the engine writes down a stack",
      program: `${OBJECT}
O = js_object()
try:
    O.defineProperty(None)
except Exception as error:
    E = O.getPrototypeOf(error.constructor)
    print(E)
    try:
        E.prepareStackTrace = lambda e, sites: sites
    except Exception as closed:
        print("closed", type(closed).__name__)
    print("OPEN" if hasattr(E, "prepareStackTrace") and E.prepareStackTrace is not None else "closed")`,
    },
    {
      name: "an error's name and message, as pairs of functions",
      program: `${OBJECT}
O = js_object()
try:
    O.defineProperty(None)
except Exception as error:
    P = error.constructor.prototype
    for name in ("name", "message", "toString", "stack"):
        try:
            P.__defineGetter__(name, print)
            print("OPEN", name)
        except Exception as closed:
            print("closed", name, type(closed).__name__)`,
    },
    {
      name: "another prototype for what is shared",
      program: `${OBJECT}
O = js_object()
for one in (O.keys(O).constructor.prototype, O.keys, O):
    try:
        O.setPrototypeOf(one, None)
        print("OPEN", str(one)[:40])
    except Exception as error:
        print("closed", type(error).__name__)`,
    },
  ],
};
