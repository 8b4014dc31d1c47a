/** JavaScript's objects that live in the interpreter, and what they lead to. */
import { REACH, WALK } from "./tools.mjs";

/** @typedef {import("./tools.mjs").Kind} Kind */

/** @type {Kind} */
export const LIVING_OBJECTS = {
  kind: "living objects",
  ways: [
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
  ],
};
