/**
 * What the ways out share. Each way is Python that prints "OPEN" and what it reached if it got
 * somewhere, and anything else if it did not.
 *
 * @typedef {object} Way
 * @property {string} name
 * @property {string} program
 * @property {true} [spoils] it leaves the interpreter such that what comes after it in a run proves nothing
 *
 * @typedef {{ kind: string, ways: Way[] }} Kind
 */

/** From a JavaScript object to the global scope. */
export const REACH = `
def reach(handle):
    """From a JavaScript object to the global scope, by every road we know."""
    script = "return (typeof self !== 'undefined' && (self.fetch || self.indexedDB || self.Worker)) ? 'OPEN globals' : 'bare'"
    for road in (
        lambda: handle.constructor.constructor(script)(),
        lambda: handle.constructor(script)(),
        lambda: handle.__proto__.constructor.constructor(script)(),
        lambda: handle.constructor.constructor.constructor(script)(),
        lambda: handle.toString.constructor(script)(),
        lambda: handle.constructor.constructor.call(None, script)(),
    ):
        try:
            print(road())
        except BaseException as error:
            print("closed:", type(error).__name__)
def js_objects():
    import gc
    return [o for o in gc.get_objects() if "JsProxy" in type(o).__name__]
`;

/** Modules that lead to JavaScript or to memory. */
export const LEADING_OUT =
  '("js", "pyodide_js", "pyodide.ffi", "pyodide.code", "pyodide.http", "pyodide.webloop", "_pyodide._core_docs", "_pyodide_core", "ctypes", "_ctypes", "_testcapi", "_testinternalcapi", "_remote_debugging", "_xxtestfuzz")';

/** Functions that a module leading out would have. */
export const LEADS = `
DANGEROUS = ("to_js", "create_proxy", "create_once_callable", "run_js", "run_sync", "CDLL", "PyDLL", "fetch", "_module", "get_code", "send_debug", "call_function")
def leads(module):
    found = [name for name in DANGEROUS if callable(vars(module).get(name))]
    from_python = getattr(module, "__file__", None) is not None
    # Pyodide's Python files have stand-ins of the same names, which only raise.
    for name in found:
        thing = vars(module)[name]
        if type(thing).__name__ == "builtin_function_or_method" or not from_python:
            print("OPEN", module, name)
`;

/** Finds every JavaScript object it can, and walks over everything they lead to. */
export const WALK = `
import gc, sys
def handles():
    found = [o for o in gc.get_objects() if type(o).__name__.startswith("Js") and "pyodide" in type(o).__module__]
    frame = sys._getframe()
    while frame:
        found += [v for v in list(frame.f_locals.values()) if type(v).__name__.startswith("Js")]
        frame = frame.f_back
    for o in gc.get_objects():
        if type(o).__module__.partition(".")[0] not in ("bridge", "bugbot", "performer"): continue
        for name in ("_send", "_begin", "_keep"):
            try:
                value = object.__getattribute__(o, name)
            except Exception:
                continue
            if type(value).__name__.startswith("Js"):
                found.append(value)
    return found
POWER = {"fetch", "postMessage", "XMLHttpRequest", "WebSocket", "indexedDB", "caches", "importScripts", "Worker", "FontFace", "fonts", "navigator", "BroadcastChannel", "webkitRequestFileSystemSync", "webkitRequestFileSystem", "FileReaderSync", "eval", "loadPackage", "addEventListener", "createObjectURL", "compileStreaming", "location"}
SEEN = set()
def walk(start, most=800):
    waiting, new = list(start), 0
    while waiting and new < most:
        thing = waiting.pop()
        try:
            if thing.js_id in SEEN: continue
            SEEN.add(thing.js_id)
            new += 1
            names = set(dir(thing))
        except Exception:
            continue
        for name in names & POWER:
            try:
                if getattr(thing, name) is not None: print("OPEN", name, "on", str(thing)[:60])
            except Exception:
                pass
        for name in list(names) + ["constructor", "prototype", "__proto__"]:
            try:
                value = getattr(thing, name)
            except Exception:
                continue
            if type(value).__name__.startswith("Js"): waiting.append(value)
    return new
def top():
    for handle in handles():
        try:
            return handle.constructor.prototype.constructor
        except Exception:
            continue
    raise LookupError("no JavaScript object was found")
`;

/** JavaScript's Object, reached from any JavaScript object. */
export const OBJECT = `${WALK}
def js_object():
    for handle in handles():
        for road in (lambda: handle.__proto__.__proto__.constructor, lambda: handle.constructor.prototype.__proto__.constructor):
            try:
                return road()
            except Exception:
                pass
    raise LookupError("no way to Object")
`;

/**
 * Reads and writes any of the interpreter's memory, by an array that claims to be larger than it is.
 * With this, Python's own fences are gone: such ways test what JavaScript can still do.
 */
export const MEMORY = `
import numpy
from numpy.lib.stride_tricks import as_strided
small = numpy.zeros(4, dtype=numpy.uint32)
here = small.__array_interface__["data"][0]
memory = as_strided(small, shape=((here // 4) + 1,), strides=(-4,))
def peek(address): return int(memory[(here - address) // 4])
def poke(address, value): memory[(here - address) // 4] = value
bytes_at = as_strided(small.view(numpy.uint8), shape=(here,), strides=(-1,))
`;

/** Any address of the interpreter, both ways, by an object that only says where its bytes are. */
export const ADDRESSES = `
import numpy
class At:
    def __init__(self, address, count, kind): self.__array_interface__ = {"data": (address, False), "shape": (count,), "typestr": kind, "version": 3}
def at(address, count, kind="<u4"): return numpy.asarray(At(address, count, kind))
`;

/** Python's own fences taken down by writing to memory: _ctypes and _pyodide_core are back. */
export const REVIVED = `${MEMORY}
whole = bytes(bytes_at[::-1])
base = here - len(whole) + 1
for module in ("_ctypes", "_pyodide_core"):
    name = whole.find(b"\\0" + module.encode() + b"\\0") + base + 1
    sought, place = (name + len(module)).to_bytes(4, "little"), -1
    while (place := whole.find(sought, place + 1)) >= 0:
        if (place + base) % 4 == 0: poke(place + base, name)
import sys
sys.meta_path[:] = [finder for finder in sys.meta_path if "NotHere" not in type(finder).__name__]
`;

/**
 * Functions of C that no module has any more, put into others: Python's functions hold the address of
 * their entry in a table, and the tables of the closed modules are still in memory.
 */
export const C_FUNCTIONS = `${ADDRESSES}
import builtins, math, sys
whole = bytes(at(1024, 8_000_000, "|u1"))
hosts = [each for module in (builtins, math, sys) for each in vars(module).values() if type(each) is type(len)]
def entry_of(function): return at(int(at(id(function), 4)[2]), 4)
def tables_with(name):
    place = -1
    while (place := whole.find(name.encode() + b"\\0", place + 1)) >= 0:
        start, sought = -1, (place + 1024).to_bytes(4, "little")
        while (start := whole.find(sought, start + 1)) >= 0:
            if start % 4 == 0 and int(at(start + 1024, 4)[2]) in (2, 3, 4, 8, 128, 130): yield start + 1024
def revived(name):
    for table in tables_with(name):
        for host in hosts:
            if entry_of(host)[2] == at(table, 4)[2]:
                hosts.remove(host)
                at(id(host), 4)[2] = table
                return host
    raise LookupError(name)
`;
