/** What a page shows of a run: names, colours and texts that are more than that to a browser. */

/** Texts that a page must show as they are. */
const TEXTS = `
MARKUP = ("<img src=x onerror='window.REACHED=1'>", "<script>window.REACHED=1</script>", "<svg onload=window.REACHED=1>", "</pre><iframe src='http://127.0.0.1:4174/'></iframe>", "javascript:window.REACHED=1", "\\x1b]8;;http://127.0.0.1:4174/\\x07x\\x1b]8;;\\x07", "\${window.REACHED=1}", "{{constructor.constructor('window.REACHED=1')()}}", "<link rel=stylesheet href=http://127.0.0.1:4174/>")
NAMES = ("__proto__", "constructor", "prototype", "toString", "hasOwnProperty", "then", "toJSON", "length", "__defineGetter__", "")
COLOURS = ("url(http://127.0.0.1:4174/)", "red;background:url(http://127.0.0.1:4174/)", "image-set('http://127.0.0.1:4174/' 1x)", "var(--x, url(//127.0.0.1:4174/))", "red}*{background:url(http://127.0.0.1:4174/)}", "url(#x)", "expression(1)", "currentColor")
`;

/** @type {import("./tools.mjs").Kind} */
export const WHAT_A_PAGE_SHOWS = {
  kind: "what a page shows",
  ways: [
    {
      name: "markup in prints, layers and plots",
      program: `${TEXTS}
from bugbot import *
for text in MARKUP:
    print(text)
    for show in (lambda: draw(text, [(50, 50)], "red", "text", 5), lambda: draw("x", [(50, 50, text)], "red", "text", 5), lambda: plot(text, 1), lambda: draw(text, [(50, 50)], "red", text, 5)):
        try:
            show()
        except BaseException as error:
            print("closed", type(error).__name__)
wait(0.5)`,
    },
    {
      name: "names that mean something to JavaScript",
      program: `${TEXTS}
from bugbot import *
for name in NAMES:
    for show in (lambda: draw(name, [(50, 50)], "red", "squares", 5), lambda: plot(name, 1), lambda: plot(name, float("nan")), lambda: draw(name, [], name, "dots", 1)):
        try:
            show()
        except BaseException as error:
            print("closed", type(error).__name__)
wait(0.5)`,
    },
    {
      name: "colours that are addresses and more",
      program: `${TEXTS}
from bugbot import *
for colour in COLOURS:
    for show in (lambda: draw("x" + colour, [(50, 50)], colour, "squares", 5), lambda: draw("x", [(50, 50)], colour, "dots", 5)):
        try:
            show()
        except BaseException as error:
            print("closed", type(error).__name__)
wait(0.5)`,
    },
    {
      name: "errors named after what they are not",
      program: `${TEXTS}
import builtins, sys, warnings
for text in MARKUP + NAMES:
    kind = type(text.replace("\\0", ""), (Exception,), {"__module__": text, "__qualname__": text, "__str__": lambda self: text})
    try:
        sys.excepthook(kind, kind(text), None)
        sys.unraisablehook
        warnings.warn(text, type(text, (UserWarning,), {}))
    except BaseException as error:
        print("closed", error)
print("closed")`,
    },
    {
      name: "time zones and languages out of files of the machine",
      program: `
import importlib, locale, os, time, zoneinfo
for key in ("../../../etc/passwd", "/etc/passwd", "Europe/Berlin", "..\\\\x", "localtime"):
    try:
        zoneinfo.reset_tzpath(["/usr/share/zoneinfo", "/etc"])
        print("OPEN", zoneinfo.ZoneInfo(key))
    except BaseException as error:
        print("closed", type(error).__name__)
os.environ["TZ"] = ":/etc/passwd"
time.tzset()
print(time.tzname)
for attempt in (lambda: importlib.import_module("gettext").translation("x", "/usr/share/locale"), lambda: open("/usr/share/locale/locale.alias").read(), lambda: locale.setlocale(locale.LC_ALL, "../../../etc/passwd")):
    try:
        print("OPEN", attempt())
    except BaseException as error:
        print("closed", type(error).__name__)`,
    },
    {
      name: "Python and JavaScript calling each other until there is no stack",
      spoils: true,
      program: `
import gc
senders = [o for o in gc.get_objects() if type(o).__name__ == "_Sender"]
depth = 0
def deeper(*given):
    global depth
    depth += 1
    for sender in senders:
        sender._send('[["print",0,"stdout","."]]', b"")
    sorted([1, 2], key=deeper)
try:
    deeper()
except BaseException as error:
    print("closed", type(error).__name__, depth)`,
    },
  ],
};
