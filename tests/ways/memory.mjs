/** The interpreter's memory, read and written by NumPy: Python's own fences are gone then. */
import { ADDRESSES, MEMORY, REVIVED, WALK } from "./tools.mjs";

/** @typedef {import("./tools.mjs").Kind} Kind */

/** @type {Kind} */
export const INTERPRETERS_MEMORY = {
  kind: "memory",
  ways: [
    {
      name: "NumPy: the closed modules put back into Python's table, then ctypes",
      spoils: true,
      program: `${MEMORY}
whole = bytes(bytes_at[::-1])
base = here - len(whole) + 1
name = whole.find(b"\\0_ctypes\\0") + base + 1
end = name + len("_ctypes")
back = 0
sought, at = end.to_bytes(4, "little"), -1
while (at := whole.find(sought, at + 1)) >= 0:
    if (at + base) % 4 == 0:
        poke(at + base, name)
        back += 1
print("put back", back)
import sys
sys.meta_path[:] = [finder for finder in sys.meta_path if "NotHere" not in type(finder).__name__]
import ctypes
lib = ctypes.PyDLL(None)
print("reached the C functions")
lib.emscripten_get_device_pixel_ratio.restype = ctypes.c_double
if lib.emscripten_get_device_pixel_ratio() != 1: print("OPEN")
try:
    if lib.emscripten_run_script_int(b"1 + 41") == 42: print("OPEN")
except BaseException as error:
    print("closed", type(error).__name__)`,
    },
    {
      name: "an array that says where its bytes are",
      program: `${ADDRESSES}
whole = at(0x400, 4_000_000, "|u1")
print("read", int(whole[:100_000].sum()))
for sought in (b"fetch(", b"indexedDB.open", b"MessagePort"):
    print("in memory" if sought in bytes(whole) else "not in memory", sought)
print("closed: all of it is this run's own")`,
    },
    {
      name: "_pyodide_core revived, and JavaScript made of text with it",
      spoils: true,
      program: `${WALK}${REVIVED}
import _pyodide_core as core
print("revived:", [name for name in dir(core) if "run" in name or "to_js" in name or "proxy" in name])
made = []
for make in (lambda: core.to_js([1, 2]), lambda: core.create_proxy(print), lambda: core.to_js({"a": b"b"}), lambda: core.create_once_callable(print)):
    try:
        made.append(make())
    except Exception as error:
        print("closed", type(error).__name__, error)
print("walked", walk(made))
for name in ("run_js", "eval_js"):
    try:
        print("OPEN", getattr(core, name)("1 + 41"))
    except Exception as error:
        print("closed", type(error).__name__)`,
    },
  ],
};
