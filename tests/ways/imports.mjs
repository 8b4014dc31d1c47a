/** Modules that lead out, imported by every road. */
import { LEADING_OUT, LEADS } from "./tools.mjs";

/** @typedef {import("./tools.mjs").Kind} Kind */

/** @type {Kind} */
export const IMPORTS = {
  kind: "imports",
  ways: [
    {
      name: "each module that leads out, by import",
      program: `${LEADS}
for name in ${LEADING_OUT}:
    try:
        leads(__import__(name, fromlist=["x"]))
    except ImportError as error:
        print("closed", error)`,
    },
    {
      name: "by the interpreter's own maker of built-in modules",
      program: `${LEADS}
import _imp
from importlib.machinery import BuiltinImporter, ModuleSpec
for name in ${LEADING_OUT}:
    try:
        module = _imp.create_builtin(ModuleSpec(name, BuiltinImporter))
    except ImportError as error:
        print("closed", error)
        continue
    if module is not None:
        leads(module)`,
    },
    {
      name: "with the finders of a plain Python in the place of ours",
      program: `${LEADS}
import sys
from importlib.machinery import BuiltinImporter, FrozenImporter, PathFinder
sys.meta_path[:] = [BuiltinImporter, FrozenImporter, PathFinder]
sys.path_importer_cache.clear()
for name in ${LEADING_OUT}:
    try:
        leads(__import__(name, fromlist=["x"]))
    except (ImportError, AttributeError) as error:
        print("closed", type(error).__name__, error)`,
    },
    {
      name: "out of the library's archive",
      program: `${LEADS}
import zipimport, sys
archive = zipimport.zipimporter("/lib/python314.zip")
sys.meta_path[:] = [finder for finder in sys.meta_path if "NotHere" not in type(finder).__name__]
for name in ("pyodide", "_pyodide", "ctypes"):
    try:
        leads(archive.load_module(name))
    except Exception as error:
        print("closed", type(error).__name__, error)`,
    },
    {
      name: "runpy",
      program: `import runpy
for name in ("pyodide.ffi", "_pyodide_core", "js"):
    try:
        got = runpy.run_module(name)
        if type(got.get("to_js")).__name__ == "builtin_function_or_method": print("OPEN", name)
    except BaseException as error:
        print("closed", type(error).__name__)`,
    },
    {
      name: "a pickle that names a function",
      program: `import pickle
for name in (b"_pyodide_core\\nto_js", b"pyodide.ffi\\ncreate_proxy", b"js\\nfetch", b"ctypes\\nPyDLL", b"pyodide.code\\nrun_js"):
    try:
        print("OPEN", pickle.loads(b"c" + name + b"\\n."))
    except BaseException as error:
        print("closed", type(error).__name__)`,
    },
    {
      name: "another interpreter in this one",
      program: `import _interpreters
made = _interpreters.create()
_interpreters.exec(made, "import js; print('OPEN', js)")`,
    },
    {
      name: "pkgutil, importlib.resources and imports by path",
      program: `import pkgutil
for name in ("js:fetch", "_pyodide_core:to_js", "ctypes:PyDLL", "pyodide_js:loadPackage"):
    try:
        print("OPEN", pkgutil.resolve_name(name))
    except BaseException as error:
        print("closed", type(error).__name__)`,
    },
    {
      name: "registering a module of JavaScript's",
      program: `from _pyodide._importhook import register_js_module, jsfinder
print("OPEN", jsfinder)`,
    },
    {
      name: "what NumPy brings of ctypes",
      program: `import numpy, numpy.ctypeslib
if numpy.ctypeslib.ctypes is not None:
    print("OPEN", numpy.ctypeslib.ctypes)
try:
    print("OPEN", numpy.zeros(3).ctypes.data_as(int))
except Exception as error:
    print("closed", type(error).__name__)`,
    },
  ],
};
