/** Messages to the page that it does not expect, and running out in the middle of something. */
import { WALK } from "./tools.mjs";

/** @typedef {import("./tools.mjs").Kind} Kind */

/** @type {Kind} */
export const MESSAGES = {
  kind: "messages",
  ways: [
    {
      name: "each callback with what it does not expect",
      spoils: true,
      program: `${WALK}
found = handles()
print("found", len(found))
for handle in found:
    for given in ((), (1,), (None, None), ("x" * 1000, b"x" * 100), ('[["end",0,"finished","forged"]]', b""), (handle, handle), ({"kind": "performed"}, b""), (10 ** 400, 1e308)):
        try:
            handle(*given)
        except BaseException as error:
            pass
print("closed")`,
    },
    {
      name: "our own sender, put out of order",
      program: `
import gc
from bugbot import *
for one in gc.get_objects():
    if type(one).__name__ == "_Sender":
        one.flush_if_due = lambda: None
        one._sent_at = 1e18
wait(1)
print("closed")`,
    },
    {
      name: "messages that a reader of JSON trips over",
      spoils: true,
      program: `${WALK}
found = handles()
print("found", len(found))
for forged in ('[["pose",NaN,0,0,0]]', '[["pose",1e999,1e999,0,0]]', '{"__proto__":{"polluted":1}}', '[["print",0,"__proto__","x"]]', '[["plot",0,"__proto__",1]]', '[["draw",0,"constructor",[],"red","dots",1]]', '[["end",0,"finished",{"toString":null}]]', '[["print",0,"out","\\\\ud800"]]', '[[[[' * 20000, '[["pose",0,0,0,0],' * 3, '{"a":1,"a":[2]}', "\\0", "1" * 100000):
    for handle in found:
        for given in ((forged,), (forged, b""), (forged, b"x" * 7), (0, forged)):
            try:
                handle(*given)
            except BaseException as error:
                pass
print("closed")`,
    },
  ],
};

/** @type {Kind} */
export const RUNNING_OUT_IN_THE_MIDDLE = {
  kind: "running out in the middle",
  ways: [
    {
      name: "no memory left in the middle of a print",
      spoils: true,
      program: `
kept = []
class Big:
    def __str__(self):
        try:
            while True: kept.append(bytearray(64 << 20))
        except MemoryError:
            pass
        return "x" * 10
try:
    print(Big(), Big())
except MemoryError:
    pass
finally:
    kept.clear()
print("closed")`,
    },
    {
      name: "no stack left where an error is told",
      program: `
class Deep(Exception):
    def __str__(self): return str(self)
    __repr__ = __str__
    def __getattribute__(self, name): return object.__getattribute__(self, name)
group = Deep()
for step in range(5000): group = ExceptionGroup("x", [group])
group.__context__ = Deep()
raise group`,
    },
    {
      name: "errors in a ring, with names that say much",
      program: `
one, two = ValueError("x" * 10_000_000), KeyError("\\ud800\\0\\x1b]0;OP\\x07")
one.__context__, two.__context__ = two, one
one.__notes__ = ["note" * 1_000_000]
raise one`,
    },
  ],
};
