/** Code of a program's own: JavaScript, libraries, bytecode, loaders. */
import { OBJECT, WALK } from "./tools.mjs";

/** @typedef {import("./tools.mjs").Kind} Kind */

/** @type {Kind} */
export const CODE_OF_ONES_OWN = {
  kind: "code of one's own",
  ways: [
    {
      name: "constructors of all kinds of functions",
      program: `${OBJECT}
O = js_object()
kinds = [O, O.keys, O.prototype.__defineGetter__, O.keys(O).values]
for kind in kinds:
    for road in (lambda: kind.constructor("return 1"), lambda: kind.constructor.constructor("return 1"), lambda: kind.__proto__.constructor("return 1"), lambda: O.getPrototypeOf(kind).constructor("return 1"), lambda: kind.constructor.new("return 1")):
        try:
            print("OPEN", road()())
        except Exception as error:
            print("closed", type(error).__name__)`,
    },
    {
      name: "a timer that takes a text",
      program: `${WALK}
for handle in handles():
    for name in ("setTimeout", "setInterval", "execScript", "Function", "eval"):
        try:
            getattr(handle, name)("self.x = 1", 0)
            print("OPEN", name)
        except Exception:
            pass
print("closed")`,
    },
    {
      name: "a library of one's own, as a module of Python's",
      program: `
import importlib.machinery, importlib.util, sys
sections = bytes([0]) + bytes([120, 7]) + b"padding" + bytes(112)
for path, body in (("/tmp/evil.so", b"\\0asm\\1\\0\\0\\0" + sections), ("/lib/python3.14/site-packages/evil.so", b"\\0asm\\1\\0\\0\\0" + sections * 3)):
    open(path, "wb").write(body)
    spec = importlib.util.spec_from_file_location("evil", path, loader=importlib.machinery.ExtensionFileLoader("evil", path))
    try:
        print("OPEN", importlib.util.module_from_spec(spec))
    except BaseException as error:
        print("closed", type(error).__name__, error)`,
    },
    {
      name: "one of NumPy's libraries, changed",
      program: `
import glob, importlib.machinery, importlib.util
path = glob.glob("/lib/python3.14/site-packages/numpy/**/_umath_linalg*.so", recursive=True)[0]
body = bytearray(open(path, "rb").read())
body[-1] ^= 1
open("/tmp/_umath_linalg.so", "wb").write(body)
spec = importlib.util.spec_from_file_location("numpy.linalg._umath_linalg", "/tmp/_umath_linalg.so", loader=importlib.machinery.ExtensionFileLoader("numpy.linalg._umath_linalg", "/tmp/_umath_linalg.so"))
try:
    print("OPEN", importlib.util.module_from_spec(spec))
except BaseException as error:
    print("closed", type(error).__name__, error)
import numpy`,
    },
    {
      name: "bytecode that reads beyond its constants",
      spoils: true,
      program: `
def f(): return None
f.__code__ = f.__code__.replace(co_code=bytes([128, 0, 82, 200, 35, 0]), co_consts=())
try:
    print(type(f()))
except BaseException as error:
    print("closed", type(error).__name__)`,
    },
    {
      name: "a debugger for another process",
      program: `import os, sys
open("/tmp/x.py", "w").write("print('OPEN')")
sys.remote_exec(os.getpid(), "/tmp/x.py")
print("closed")`,
    },
    {
      name: "a small library of one's own, which is no wrapper of a function",
      program: `
import importlib.machinery, importlib.util
def section(number, body): return bytes([number, len(body)]) + body
def name(text): return bytes([len(text)]) + text
body = b"\\0asm\\1\\0\\0\\0"
body += section(0, name(b"dylink.0") + bytes([1, 4, 0, 0, 0, 0]))
body += section(1, bytes([1, 0x60, 0, 1, 0x7f]))
body += section(2, bytes([1]) + name(b"env") + name(b"Py_GetVersion") + bytes([0, 0]))
body += section(7, bytes([1]) + name(b"PyInit_evil") + bytes([0, 0]))
print(len(body), "bytes")
open("/tmp/evil.so", "wb").write(body)
import _imp
spec = importlib.machinery.ModuleSpec("evil", None, origin="/tmp/evil.so")
try:
    _imp.create_dynamic(spec)
    print("OPEN: it was loaded")
except ImportError as error:
    print("closed", error)
except SystemError as error:
    print("OPEN: it was loaded and called", error)`,
    },
  ],
};

/** @type {Kind} */
export const BYTECODE_AND_LOADERS = {
  kind: "bytecode and loaders",
  ways: [
    {
      name: "code objects with no room on their stack",
      spoils: true,
      program: `
def f(a, b): return [a, b, (a, b)]
f.__code__ = f.__code__.replace(co_stacksize=0)
print(f(1, 2))
def g(): return 1
g.__code__ = g.__code__.replace(co_code=bytes(range(256)) * 4)
try:
    g()
except BaseException as error:
    print("closed", type(error).__name__)`,
    },
    {
      name: "code from marshal's bytes, and bytes that are none",
      program: `
import marshal, types
source = "import js; print('OPEN', js)"
try:
    exec(marshal.loads(marshal.dumps(compile(source, "x", "exec"))))
except ImportError as error:
    print("closed", error)
for bad in (b"c" + bytes(100), b"[\\xff\\xff\\xff\\x7f", b"(" * 10000, b"r\\xff\\xff\\xff\\xff"):
    try:
        print(type(marshal.loads(bad)))
    except BaseException as error:
        print("closed", type(error).__name__)`,
    },
    {
      name: "frozen modules, and modules loaded from a file again",
      program: `
import _imp, importlib, sys
from importlib.machinery import ExtensionFileLoader, ModuleSpec, SourceFileLoader
for name in ("js", "ctypes", "_pyodide_core", "pyodide", "_pyodide._core_docs"):
    for make in (lambda: _imp.get_frozen_object(name), lambda: _imp.init_frozen(name), lambda: importlib.reload(sys.modules[name]), lambda: _imp.create_dynamic(ModuleSpec(name, None, origin="/lib/python3.14/lib-dynload/" + name + ".so"))):
        try:
            made = make()
            if made is not None and any(callable(getattr(made, each, None)) for each in ("to_js", "run_js", "PyDLL", "create_proxy")): print("OPEN", made)
        except BaseException as error:
            print("closed", type(error).__name__)`,
    },
    {
      name: "names that are others once they are made plain",
      program: `
import importlib
for name in ("\\uff4a\\uff53", "js\\0", " js", "js ", "JS", "js.", ".js", "\\u02b2s", "js\\u200b", "_\\uff50yodide_core", "_\\u0063types"):
    for load in (__import__, importlib.import_module):
        try:
            print("OPEN", load(name))
        except BaseException as error:
            print("closed", type(error).__name__)
try:
    exec("import \\uff4a\\uff53; print('OPEN', \\uff4a\\uff53)")
except BaseException as error:
    print("closed", type(error).__name__)`,
    },
    {
      name: "path files, path hooks and runpy on an archive",
      program: `
import os, runpy, site, sys
open("/tmp/out.pth", "w").write("import js; print('OPEN', js)\\n")
site.addpackage("/tmp", "out.pth", set())
sys.path_hooks.insert(0, lambda path: (print("hook", path), (_ for _ in ()).throw(ImportError))[1])
for path in ("/lib/python314.zip", "/lib/python3.14/site-packages"):
    try:
        runpy.run_path(path)
    except BaseException as error:
        print("closed", type(error).__name__)
sys.path_hooks.pop(0)`,
    },
    {
      name: "buffers that go while they are lent",
      program: `
import array, io
class Grows(io.RawIOBase):
    def readable(self): return True
    def readinto(self, given):
        self.kept = given
        return 0
one = Grows()
io.BufferedReader(one).read(10)
try:
    print(bytes(one.kept)[:4])
    one.kept[:4] = b"evil"
except BaseException as error:
    print("closed", type(error).__name__)
numbers = array.array("q", range(1000))
view = memoryview(numbers)
try:
    numbers.extend(range(10000))
    print("OPEN")
except BufferError as error:
    print("closed", error)`,
    },
  ],
};
