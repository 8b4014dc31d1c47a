/**
 * More ways out, by kind, from somebody who has read the code. Each is Python that prints "OPEN" and
 * what it reached if it got somewhere. With NumPy a program can write to any memory, so those ways
 * test what JavaScript can still do when Python's own fences are gone.
 */
import type { WayOut } from "./ways-out.ts";

export interface Kind {
  kind: string;
  ways: WayOut[];
}

/** Modules that lead to JavaScript or to memory. */
const LEADING_OUT =
  '("js", "pyodide_js", "pyodide.ffi", "pyodide.code", "pyodide.http", "pyodide.webloop", "_pyodide._core_docs", "_pyodide_core", "ctypes", "_ctypes", "_testcapi", "_testinternalcapi", "_remote_debugging", "_xxtestfuzz")';

/** Functions that a module leading out would have. */
const LEADS = `
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
const WALK = `
import gc, sys
def handles():
    found = [o for o in gc.get_objects() if type(o).__name__.startswith("Js") and "pyodide" in type(o).__module__]
    frame = sys._getframe()
    while frame:
        found += [v for v in list(frame.f_locals.values()) if type(v).__name__.startswith("Js")]
        frame = frame.f_back
    for o in gc.get_objects():
        for name in ("_send", "_begin", "_keep"):
            try:
                value = object.__getattribute__(o, name)
            except Exception:
                continue
            if type(value).__name__.startswith("Js"):
                found.append(value)
    return found
POWER = {"fetch", "postMessage", "XMLHttpRequest", "WebSocket", "indexedDB", "caches", "importScripts", "Worker", "FontFace", "fonts", "navigator", "BroadcastChannel", "webkitRequestFileSystemSync", "webkitRequestFileSystem", "FileReaderSync", "eval", "loadPackage", "addEventListener", "createObjectURL", "compileStreaming", "location"}
def walk(start, most=800):
    waiting, seen = list(start), set()
    while waiting and len(seen) < most:
        thing = waiting.pop()
        try:
            if thing.js_id in seen: continue
            seen.add(thing.js_id)
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
    return len(seen)
def top():
    for handle in handles():
        try:
            return handle.constructor.prototype.constructor
        except Exception:
            continue
    raise LookupError("no JavaScript object was found")
`;

/** JavaScript's Object, reached from any JavaScript object. */
const OBJECT = `${WALK}
def js_object():
    for handle in handles():
        for road in (lambda: handle.__proto__.__proto__.constructor, lambda: handle.constructor.prototype.__proto__.constructor):
            try:
                return road()
            except Exception:
                pass
    raise LookupError("no way to Object")
`;

/** Reads and writes any of the interpreter's memory, by an array that claims to be larger than it is. */
const MEMORY = `
import numpy
from numpy.lib.stride_tricks import as_strided
small = numpy.zeros(4, dtype=numpy.uint32)
here = small.__array_interface__["data"][0]
memory = as_strided(small, shape=((here // 4) + 1,), strides=(-4,))
def peek(address): return int(memory[(here - address) // 4])
def poke(address, value): memory[(here - address) // 4] = value
bytes_at = as_strided(small.view(numpy.uint8), shape=(here,), strides=(-1,))
`;

const imports: WayOut[] = [
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
];

const living: WayOut[] = [
  {
    name: "functions of Pyodide's that the collector knows",
    program: `import gc
for one in gc.get_objects():
    name = getattr(one, "__name__", None) if type(one).__name__ == "builtin_function_or_method" else None
    if name in ("to_js", "create_proxy", "create_once_callable", "run_js", "run_sync", "raw_call", "destroy_proxies", "trigger_fatal_error"):
        print("OPEN", one)`,
  },
  {
    name: "dictionaries with those functions in them",
    program: `import gc
for one in gc.get_objects():
    if type(one) is dict and type(one.get("to_js")).__name__ == "builtin_function_or_method":
        print("OPEN", list(one)[:5])`,
  },
  {
    name: "classes of Pyodide's, and what they have to give",
    program: `def below(kind, seen):
    for each in type.__subclasses__(kind):
        if each not in seen:
            seen.add(each)
            below(each, seen)
    return seen
for kind in below(object, set()):
    if kind.__name__.startswith("Js") or "pyodide" in (kind.__module__ or ""):
        for name, value in list(vars(kind).items()):
            if type(value).__name__ == "JsProxy": print("OPEN", kind, name)`,
  },
  {
    name: "a walk over all that any JavaScript object leads to",
    program: `${WALK}
print("walked", walk(handles()))`,
  },
  {
    name: "modules' loaders and their globals",
    program: `${WALK}
for module in list(sys.modules.values()):
    loader = getattr(module, "__loader__", None)
    for name in ("jsproxy", "jsproxies", "hook"):
        if hasattr(loader, name): print("OPEN", module, name)
    for function in list(getattr(module, "__dict__", {}).values()):
        names = getattr(function, "__globals__", None)
        for value in list(names.values()) if type(names) is dict else ():
            if type(value).__name__.startswith("Js"): walk([value], 300)`,
  },
  {
    name: "frames of an exception from our own code",
    program: `${WALK}
from bugbot import *
try:
    forward("nonsense")
except Exception as error:
    here = error.__traceback__
    while here:
        found = [v for v in here.tb_frame.f_locals.values() if type(v).__name__.startswith("Js")]
        walk(found, 300)
        here = here.tb_next
for thread, frame in sys._current_frames().items():
    while frame:
        walk([v for v in frame.f_locals.values() if type(v).__name__.startswith("Js")], 300)
        frame = frame.f_back`,
  },
  {
    name: "watching each call that our code makes",
    program: `${WALK}
from bugbot import *
import sys
caught = []
def watch(frame, event, what):
    if event == "c_call" and type(what).__name__.startswith("Js"): caught.append(what)
    for value in list(frame.f_locals.values()):
        if type(value).__name__.startswith("Js"): caught.append(value)
sys.setprofile(watch)
wait(0.5); print("x"); wait(0.5)
sys.setprofile(None)
walk(caught, 500)`,
  },
  {
    name: "sys.monitoring and audit hooks",
    program: `${WALK}
import sys
caught = []
sys.addaudithook(lambda event, given: caught.extend(v for v in given if type(v).__name__.startswith("Js")))
events = sys.monitoring.events
sys.monitoring.use_tool_id(3, "mine")
sys.monitoring.register_callback(3, events.CALL, lambda code, at, what, first: caught.extend(v for v in (what, first) if type(v).__name__.startswith("Js")))
sys.monitoring.set_events(3, events.CALL)
from bugbot import *
wait(0.5); print("x"); wait(0.5)
sys.monitoring.set_events(3, 0)
walk(caught, 500)`,
  },
  {
    name: "the raw streams and the terminal's device",
    program: `${WALK}
import os, sys, fcntl
for stream in (sys.stdin, sys.stdout, sys.stderr, sys.__stdin__, sys.__stdout__, sys.__stderr__):
    for name in ("buffer", "raw", "_stream", "_send", "write"):
        value = getattr(stream, name, None)
        if type(value).__name__.startswith("Js"): walk([value], 300)
for path in ("/dev/stdin", "/dev/stdout", "/dev/stderr", "/dev/tty", "/dev/random", "/dev/mem", "/proc/self/mem", "/proc/self/environ"):
    try:
        with open(path, "rb", buffering=0) as device:
            if path in ("/dev/mem", "/proc/self/mem"): print("OPEN", path, device.read(4))
    except OSError as error:
        print("closed", error)`,
  },
  {
    name: "weak references, atexit and finalisers",
    program: `${WALK}
import weakref, atexit
class Late:
    def __del__(self): walk(handles(), 200)
late = Late()
late.me = late
atexit.register(lambda: walk(handles(), 200))
weakref.finalize(late, lambda: walk(handles(), 200))
del late
gc.collect()
atexit._run_exitfuncs()`,
  },
  {
    name: "hooks that are called in the middle of our code",
    program: `${WALK}
import builtins, json, sys, warnings
from bugbot import *
looking = []
def look(*a, **k):
    if not looking:
        looking.append(True)
        walk(handles(), 200)
        looking.clear()
sys.unraisablehook = sys.excepthook = sys.displayhook = warnings.showwarning = look
real = json.dumps
json.dumps = lambda *a, **k: (look(), real(*a, **k))[1]
warnings.warn("look")
wait(0.5)
json.dumps = real`,
  },
];

const planting: WayOut[] = [
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
];

const code: WayOut[] = [
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
    breaks: true,
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
    breaks: true,
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
    breaks: true,
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
];

const memory: WayOut[] = [
  {
    name: "NumPy: the closed modules put back into Python's table, then ctypes",
    breaks: true,
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
];

const network: WayOut[] = [
  {
    name: "every protocol of the library",
    program: `
import ftplib, http.client, imaplib, poplib, smtplib, socket, urllib.request, xmlrpc.client
attempts = {
    "ftp": lambda: ftplib.FTP("127.0.0.1", timeout=1),
    "http": lambda: http.client.HTTPConnection("127.0.0.1", 4174, timeout=1).request("GET", "/"),
    "imap": lambda: imaplib.IMAP4("127.0.0.1", timeout=1),
    "pop": lambda: poplib.POP3("127.0.0.1", timeout=1),
    "smtp": lambda: smtplib.SMTP("127.0.0.1", 4174, timeout=1),
    "xmlrpc": lambda: xmlrpc.client.ServerProxy("http://127.0.0.1:4174/").x(),
    "data": lambda: urllib.request.urlopen("http://127.0.0.1:4174/", timeout=1),
}
for name, attempt in attempts.items():
    try:
        attempt()
        print("OPEN", name)
    except BaseException as error:
        print("closed", name, type(error).__name__)`,
  },
  {
    name: "listening, datagrams, and sockets of the machine",
    program: `
import socket
for family, kind, address in ((socket.AF_INET, socket.SOCK_STREAM, ("127.0.0.1", 4999)), (socket.AF_INET, socket.SOCK_DGRAM, ("127.0.0.1", 4998)), (getattr(socket, "AF_UNIX", 1), socket.SOCK_STREAM, "/tmp/s")):
    try:
        s = socket.socket(family, kind)
        s.bind(address)
        s.listen()
        s.settimeout(0.1)
        s.accept()
        print("OPEN")
    except BaseException as error:
        print("closed", type(error).__name__)
try:
    s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    s.sendto(b"secret", ("127.0.0.1", 4174))
    answer = s.recv(10)
    if answer: print("OPEN", answer)
except BaseException as error:
    print("closed", type(error).__name__)`,
  },
  {
    name: "asyncio's connections",
    program: `
import asyncio
async def main():
    reader, writer = await asyncio.wait_for(asyncio.open_connection("127.0.0.1", 4174), 1)
    writer.write(b"GET /secret HTTP/1.0\\r\\n\\r\\n")
    print("OPEN", await reader.read(10))
asyncio.run(main())`,
  },
  {
    name: "names looked up, which is a message too",
    program: `
import socket
for attempt in (lambda: socket.getaddrinfo("secret.example.test", 80), lambda: socket.gethostbyname("secret.example.test")):
    try:
        print("closed: made up", attempt())
    except BaseException as error:
        print("closed", type(error).__name__)`,
  },
];

const machine: WayOut[] = [
  {
    name: "processes of every kind",
    program: `
import os, subprocess
attempts = {
    "spawn": lambda: os.posix_spawn("/bin/sh", ["sh"], {}),
    "popen": lambda: os.popen("echo x").read() == "x\\n" or 1 / 0,
    "call": lambda: subprocess.check_output("echo x", shell=True),
    "spawnv": lambda: os.spawnv(os.P_WAIT, "/bin/sh", ["sh"]) == 0 or 1 / 0,
    "forkpty": lambda: os.forkpty(),
}
for name, attempt in attempts.items():
    try:
        attempt()
        print("OPEN", name)
    except BaseException as error:
        print("closed", name, type(error).__name__)`,
  },
  {
    name: "pools of threads and processes",
    program: `
from concurrent.futures import ThreadPoolExecutor
try:
    with ThreadPoolExecutor(1) as pool: print("OPEN", pool.submit(pow, 2, 3).result(timeout=1))
except BaseException as error:
    print("closed", type(error).__name__)
try:
    import multiprocessing
    p = multiprocessing.Process(target=print)
    p.start()
    print("OPEN")
except BaseException as error:
    print("closed", type(error).__name__)`,
  },
  {
    name: "mounting and devices",
    program: `
import os
for attempt in (lambda: os.mknod("/dev/mine", 0o20666, os.makedev(5, 0)), lambda: os.chroot("/tmp"), lambda: os.link("/dev/stdout", "/tmp/out"), lambda: os.open("/proc/1/mem", os.O_RDWR)):
    try:
        print("closed: no more than a file in memory", attempt())
    except BaseException as error:
        print("closed", type(error).__name__)`,
  },
  {
    name: "a file left for the next run",
    program: `
import os
for path in ("/lib/python3.14/site-packages/sitecustomize.py", "/lib/python3.14/site-packages/bugbot/__init__.py", "/home/pyodide/left.py", "/tmp/left-by-a-program", "/lib/python314.zip"):
    if path == "/tmp/left-by-a-program" and os.path.exists(path): print("OPEN", path)
    try:
        open(path, "w").write("print('OPEN: code that was left')")
    except OSError as error:
        print("closed", error)`,
  },
  {
    name: "the same again, which would find it",
    program: `
import os
print("OPEN" if os.path.exists("/home/pyodide/left.py") and "run-of-its-own" in open("/home/pyodide/left.py").read() else "closed")`,
  },
];

const messages: WayOut[] = [
  {
    name: "each callback with what it does not expect",
    breaks: true,
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
];

export const WAYS_BY_KIND: Kind[] = [
  { kind: "imports", ways: imports },
  { kind: "living objects", ways: living },
  { kind: "planting in JavaScript's own objects", ways: planting },
  { kind: "code of one's own", ways: code },
  { kind: "memory", ways: memory },
  { kind: "network", ways: network },
  { kind: "the machine", ways: machine },
  { kind: "messages", ways: messages },
];
