/** What holds JavaScript's objects, and what Pyodide's classes do with them. */
import { OBJECT, WALK } from "./tools.mjs";

/** @typedef {import("./tools.mjs").Kind} Kind */

/** @type {Kind} */
export const WHAT_IS_HELD_BY_WHOM = {
  kind: "what is held by whom",
  ways: [
    {
      name: "closures of all functions, and what partial functions hold",
      program: `${WALK}
import functools, types
for one in gc.get_objects():
    held = []
    if type(one) is types.FunctionType: held = [cell.cell_contents for cell in one.__closure__ or () if "empty" not in repr(cell)]
    elif type(one) is functools.partial: held = [one.func, *one.args, *one.keywords.values()]
    elif type(one) is types.MethodType: held = [one.__self__]
    found = [each for each in held if type(each).__name__.startswith("Js")]
    if found: walk(found, 300)
print("closed")`,
    },
    {
      name: "who refers to JavaScript's objects, and to what those refer",
      program: `${WALK}
found = handles()
held = [each for each in gc.get_referents(*found, *{type(one) for one in found}) if type(each).__name__.startswith("Js")]
for holder in gc.get_referrers(*found):
    if type(holder) is dict: held += [v for v in holder.values() if type(v).__name__.startswith("Js")]
gc.callbacks.append(lambda phase, info: held.extend(handles()[:1]))
gc.collect()
gc.callbacks.pop()
print("walked", walk(held))`,
    },
    {
      name: "what errors of JavaScript's hold, by context and cause",
      program: `${WALK}
for handle in handles():
    for given in ((), ("]", None), (None,) * 9, (object(),)):
        try:
            handle(*given)
        except BaseException as error:
            while error is not None:
                held = [getattr(error, name, None) for name in ("js_error", "stack", "cause", "constructor")] + list(error.args)
                walk([each for each in [error, *held] if type(each).__name__.startswith("Js")], 300)
                error = error.__context__ or error.__cause__
print("closed")`,
    },
    {
      name: "signals' handlers and the frames they see",
      program: `${WALK}
import signal
from bugbot import *
def handler(number, frame):
    while frame:
        walk([v for v in frame.f_locals.values() if type(v).__name__.startswith("Js")], 100)
        frame = frame.f_back
for number in (signal.SIGINT, signal.SIGTERM, signal.SIGALRM, signal.SIGUSR1):
    signal.signal(number, handler)
    signal.raise_signal(number)
for later in (lambda: signal.alarm(1), lambda: signal.setitimer(signal.ITIMER_REAL, 0.01)):
    try:
        later()
    except BaseException as error:
        print("closed", type(error).__name__)
wait(0.5)
signal.signal(signal.SIGINT, signal.default_int_handler)`,
    },
    {
      name: "each instruction watched, in our own code too",
      program: `${WALK}
from bugbot import *
caught = []
def watch(frame, event, what):
    frame.f_trace_opcodes = True
    if len(caught) < 50: caught.extend(v for v in list(frame.f_locals.values()) if type(v).__name__.startswith("Js"))
    return watch
sys.settrace(watch)
wait(0.2); print("x")
sys.settrace(None)
print("walked", walk(caught, 500))`,
    },
  ],
};

/** @type {Kind} */
export const PYODIDES_OWN_CLASSES = {
  kind: "Pyodide's own classes",
  ways: [
    {
      name: "what Pyodide makes of a Python function for JavaScript",
      spoils: true,
      program: `${OBJECT}
O = js_object()
def mine(*given): return 1
for road in (lambda: O.getPrototypeOf(mine), lambda: O.fromEntries([["a", mine]]), lambda: O.assign(O.fromEntries([]), mine), lambda: O.getOwnPropertyDescriptors(mine), lambda: O.entries(mine)):
    try:
        found = road()
        print("walked", walk([found], 300))
        for name in ("getBuffer", "toJs", "destroy", "apply"):
            setattr(found, name, mine)
    except Exception as error:
        print("closed", type(error).__name__)`,
    },
    {
      name: "this, in functions that are called without one",
      program: `${OBJECT}
O = js_object()
A = O.keys(O)
for function in (O.prototype.valueOf, O.prototype.toString, O.prototype.toLocaleString, A.concat, A.values, A.entries, A.fill, A.sort, A.reverse):
    for given in (None, 1, "x"):
        try:
            found = function.call(given)
            if type(found).__name__.startswith("Js"): walk([found], 100)
        except Exception as error:
            pass
for name in ("__lookupGetter__", "__lookupSetter__"):
    try:
        print("walked", walk([getattr(O.prototype, name)("__proto__")], 100))
    except Exception as error:
        print("closed", type(error).__name__)`,
    },
    {
      name: "WebAssembly, Atomics and shared memory from any object",
      program: `${OBJECT}
O = js_object()
POWER |= {"compile", "instantiate", "instantiateStreaming", "compileStreaming", "wait", "waitAsync", "Memory", "grow", "loadDynlib", "FS", "wasmTable", "_module"}
POWER -= {"eval"}
print("walked", walk([O, *handles()], 1500))`,
    },
    {
      name: "the class of JavaScript's objects, called and copied",
      program: `${WALK}
import copy, pickle
for handle in handles()[:5]:
    kind = type(handle)
    for attempt in (lambda: kind(), lambda: kind(handle), lambda: kind.__new__(kind), lambda: object.__new__(kind), lambda: copy.copy(handle), lambda: copy.deepcopy(handle), lambda: pickle.dumps(handle), lambda: type("Mine", (kind,), {})()):
        try:
            made = attempt()
            if type(made).__name__.startswith("Js"): walk([made], 200)
        except BaseException as error:
            print("closed", type(error).__name__)`,
    },
    {
      name: "the functions of that class, on what is none of it",
      program: `${WALK}
for kind in {type(handle) for handle in handles()}:
    for name, value in list(vars(kind).items()):
        for given in ((), (None,), (kind,), (object(), object())):
            try:
                made = value(*given)
                if type(made).__name__.startswith("Js"): walk([made], 200)
            except BaseException:
                pass
print("closed")`,
    },
    {
      name: "a thenable, and waiting for it",
      program: `${OBJECT}
import asyncio
O = js_object()
kept = []
def then(*given):
    kept.extend(given)
    walk([each for each in given if type(each).__name__.startswith("Js")], 300)
async def main():
    try:
        await O.fromEntries([["then", then]])
    except BaseException as error:
        print("closed", type(error).__name__)
for run in (lambda: asyncio.run(main()), lambda: main().send(None), lambda: asyncio.get_event_loop().run_until_complete(main())):
    try:
        run()
    except BaseException as error:
        print("closed", type(error).__name__)
print("kept", len(kept))`,
    },
    {
      name: "asynchronous generators, their frames and their hooks",
      program: `${WALK}
def look(one):
    frame = one.ag_frame
    while frame:
        walk([v for v in frame.f_locals.values() if type(v).__name__.startswith("Js")], 200)
        frame = frame.f_back
sys.set_asyncgen_hooks(firstiter=look, finalizer=look)
async def numbers():
    for handle in handles()[:3]: yield handle
made = numbers()
try:
    made.asend(None).send(None)
except StopIteration as got:
    walk([got.value], 300)
look(made)
del made
gc.collect()`,
    },
  ],
};
