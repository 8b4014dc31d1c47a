/** What Pyodide offers a program in a page that is not locked down. */
import { REACH } from "./tools.mjs";

/** @typedef {import("./tools.mjs").Kind} Kind */

/** @type {Kind} */
export const PYODIDES_OWN_MODULES = {
  kind: "Pyodide's own modules",
  ways: [
    { name: "import js", program: `import js\nprint("OPEN", js.fetch)` },
    { name: "from js import fetch", program: `from js import fetch\nprint("OPEN", fetch)` },
    { name: "import pyodide_js", program: `import pyodide_js\nprint("OPEN", pyodide_js._module)` },
    {
      name: "import js after clearing sys.modules",
      program: `import sys\nsys.modules.pop("js", None)\nsys.modules.pop("pyodide_js", None)\nimport js\nprint("OPEN", js)`,
    },
    {
      name: "the import hook's own table",
      program: `
from _pyodide._importhook import jsfinder
print(dict(jsfinder.jsproxies))
if jsfinder.jsproxies:
    print("OPEN")`,
    },
    {
      name: "run_js",
      program: `from pyodide.code import run_js\nprint("OPEN", run_js("self.fetch || 1"))`,
    },
    {
      name: "pyodide.code internals",
      program: `import pyodide.code\nimport _pyodide_core\nfor n in dir(_pyodide_core):\n    if n in ("run_js", "eval_js", "js", "raw_call"):\n        thing = getattr(_pyodide_core, n)\n        try:\n            print("OPEN", n, thing("self.fetch || 1"))\n        except BaseException as e:\n            print("closed", n, type(e).__name__)`,
    },
    {
      name: "pyfetch",
      program: `
import asyncio
from pyodide.http import pyfetch
coroutine = pyfetch("index.html")
try:
    coroutine.send(None)
    print("OPEN")
except StopIteration as s:
    print("OPEN", s.value)`,
    },
    {
      name: "open_url",
      program: `from pyodide.http import open_url\nprint("OPEN", open_url("index.html").read())`,
    },
    {
      name: "ctypes: emscripten_run_script",
      program: `
import ctypes
lib = ctypes.CDLL(None)
lib.emscripten_run_script(b"self.postMessage({kind:'finished', id: 0})")
lib.emscripten_run_script_int.restype = ctypes.c_int
if lib.emscripten_run_script_int(b"typeof fetch == 'function' ? 1 : 0"):
    print("OPEN")`,
    },
    {
      name: "ctypes: emscripten_async_wget and friends",
      program: `
import ctypes
lib = ctypes.CDLL(None)
for name in ("emscripten_async_wget", "emscripten_fetch", "emscripten_websocket_new", "emscripten_idb_load"):
    try:
        getattr(lib, name)
        print("there", name)
    except AttributeError:
        print("closed", name)
lib.emscripten_async_wget(b"index.html", b"/tmp/out", None, None)`,
    },
    {
      name: "an object made by to_js",
      program: `${REACH}
from pyodide.ffi import to_js
reach(to_js([1, 2, 3]))
reach(to_js(b"abc"))
reach(to_js({"a": [1]}))`,
    },
    {
      name: "a proxy made by create_proxy",
      program: `${REACH}
from pyodide.ffi import create_proxy
reach(create_proxy(lambda: 1))
reach(create_proxy([]))`,
    },
    {
      name: "the event loop's timers",
      program: `${REACH}
import pyodide.webloop as w
for name, value in list(vars(w).items()):
    if "JsProxy" in type(value).__name__:
        reach(value)
import asyncio
loop = asyncio.new_event_loop()
loop.call_soon(print, "later")`,
    },
    {
      name: "an exception from JavaScript",
      program: `${REACH}
from pyodide.ffi import to_js, JsException
try:
    to_js([1]).at.call(None)
except JsException as error:
    reach(error)
    reach(getattr(error, "js_error", error))`,
    },
    {
      name: "a promise and its constructor",
      program: `${REACH}
from pyodide.ffi import create_once_callable, to_js
import pyodide.ffi
array = to_js([3, 1, 2])
reach(array.map)
reach(array.sort)
reach(array.entries())`,
    },
    {
      name: "storage",
      program: `
from pyodide.ffi import to_js
thing = to_js([1])
for name in ("indexedDB", "caches", "localStorage", "sessionStorage", "cookieStore", "navigator"):
    try:
        print("OPEN", getattr(thing, name))
    except AttributeError:
        print("closed", name)
import js`,
    },
    {
      name: "mounting the browser's file system",
      program: `
import pyodide_js
pyodide_js.FS.mount(pyodide_js.FS.filesystems.IDBFS, {}, "/mnt")
print("OPEN")`,
    },
    {
      name: "micropip",
      program: `import micropip\nprint("OPEN", micropip)`,
    },
    {
      name: "loading a package from outside",
      program: `
import pyodide._package_loader as p
print([n for n in dir(p) if "load" in n])
from pyodide_js import loadPackage
loadPackage("http://127.0.0.1:4174/x.whl")
print("OPEN")`,
    },
    {
      name: "a WebAssembly module of one's own through ctypes",
      program: `
import ctypes
open("/tmp/evil.so", "wb").write(b"\\0asm\\1\\0\\0\\0")
ctypes.CDLL("/tmp/evil.so")
print("OPEN")`,
    },
  ],
};
