/**
 * Ways a program could try to get out of its worker. Each is Python that prints "OPEN" and what it
 * reached if it got somewhere, and anything else if it did not. `reach(handle)` is given to all of
 * them: from any JavaScript object it tries the roads to code made from text.
 */

const REACH = `
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

export interface WayOut {
  name: string;
  program: string;
  /** Trying it breaks the interpreter, so that what comes after it in a run is not carried out. */
  breaks?: true;
}

export const WAYS_OUT: WayOut[] = [
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
    breaks: true,
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
    name: "urllib",
    program: `import urllib.request\nprint("OPEN", urllib.request.urlopen("http://127.0.0.1:4174/").read())`,
  },
  {
    name: "a socket",
    program: `
import socket
s = socket.create_connection(("127.0.0.1", 4174), timeout=2)
s.sendall(b"GET / HTTP/1.0\\r\\n\\r\\n")
data = s.recv(10)
if data:
    print("OPEN", data)`,
  },
  {
    name: "http.client",
    program: `
import http.client
c = http.client.HTTPConnection("127.0.0.1", 4174, timeout=2)
c.request("GET", "/")
print("OPEN", c.getresponse().status)`,
  },
  {
    name: "ctypes: emscripten_run_script",
    breaks: true,
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
    name: "the function that sends the trace, from the frames",
    program: `${REACH}
import sys
frame = sys._getframe()
while frame:
    for value in list(frame.f_locals.values()):
        if "JsProxy" in type(value).__name__:
            reach(value)
    frame = frame.f_back`,
  },
  {
    name: "JavaScript objects the collector knows",
    program: `${REACH}
found = js_objects()
print(len(found))
for thing in found:
    reach(thing)`,
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
    name: "every loaded module's JavaScript objects",
    program: `${REACH}
import sys
for module in list(sys.modules.values()):
    for name, value in list(getattr(module, "__dict__", {}).items()):
        if "JsProxy" in type(value).__name__:
            print(getattr(module, "__name__", "?"), name)
            reach(value)`,
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
    name: "another process",
    program: `import subprocess\nprint("OPEN", subprocess.run(["ls"], capture_output=True))`,
  },
  {
    name: "os.system, os.fork, os.execv",
    program: `
import os
for attempt in (lambda: os.system("ls") == 0, lambda: os.fork(), lambda: os.execv("/bin/ls", ["ls"])):
    try:
        if attempt():
            print("OPEN")
        else:
            print("closed")
    except BaseException as error:
        print("closed", type(error).__name__)`,
  },
  {
    name: "a thread",
    program: `import threading\nt = threading.Thread(target=print, args=("OPEN",))\nt.start()`,
  },
  {
    name: "webbrowser",
    program: `import webbrowser\nprint("OPEN" if webbrowser.open("http://127.0.0.1:4174/") else "closed")`,
  },
  {
    name: "a WebAssembly module of one's own through ctypes",
    program: `
import ctypes
open("/tmp/evil.so", "wb").write(b"\\0asm\\1\\0\\0\\0")
ctypes.CDLL("/tmp/evil.so")
print("OPEN")`,
  },
  {
    name: "what has loaded modules that are gone, and all else of Pyodide's with attributes",
    program: `
import gc
for one in gc.get_objects():
    if "pyodide" not in str(type(one).__module__): continue
    try:
        held = vars(one)
    except TypeError:
        continue
    for name, value in list(held.items()):
        if any(kind.__name__ == "JsProxy" for kind in type(value).__mro__): print("OPEN", one, name)
print("closed")`,
  },
  {
    name: "a small library of one's own, which is no wrapper of a function",
    breaks: true,
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
];
