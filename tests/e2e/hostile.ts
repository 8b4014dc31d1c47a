/**
 * Hostile and broken programs, each with the end it must come to. After each of them the next
 * program must run as if nothing had been.
 */

export interface Hostile {
  name: string;
  program: string;
  status: "finished" | "fault" | "limit" | "stopped";
  /**
   * Python's name of the error, for a fault. InternalError where the program has broken what the
   * run itself is made of, and nowhere else.
   */
  type?: RegExp;
  /** The learner's line that must be named; null when no line can be known. */
  line?: number | null;
  says?: RegExp;
  /** The learner's line that the message names, of a program that ended without an error. */
  names?: number;
  /** Stands for its kind in `npm test`, beside those of bad-input.spec.ts; the others are in `npm run test:long` only. */
  sample?: true;
  /** Nothing of it is run, or what it has printed is lost with its interpreter. */
  mute?: true;
}

export const HOSTILE: Hostile[] = [
  {
    name: "recursion without end",
    program: "def f(n):\n    return f(n + 1)\nf(0)",
    status: "fault",
    type: /RecursionError/,
    line: 2,
  },
  {
    name: "recursion through __repr__",
    mute: true,
    program: "class A:\n    def __repr__(self):\n        return repr([self])\nprint(A())",
    status: "fault",
    type: /RecursionError/,
    line: 3,
  },
  {
    name: "recursion through sorted",
    sample: true,
    mute: true,
    program: "def f(n):\n    return sorted([1, 2], key=lambda x: f(n + 1))\nf(0)",
    status: "fault",
    type: /RecursionError/,
    line: 2,
  },
  {
    name: "recursion through __getattr__",
    mute: true,
    program: "class A:\n    def __getattr__(self, name):\n        return self.more\nA().x",
    status: "fault",
    type: /RecursionError/,
    line: 3,
  },
  {
    name: "recursion through a property",
    program: "class A:\n    @property\n    def x(self):\n        return self.x\nA().x",
    status: "fault",
    type: /RecursionError/,
    line: 4,
  },
  {
    name: "recursion through map and str.join",
    mute: true,
    program: 'def f(n):\n    return "".join(map(f, [n + 1]))\nf(0)',
    status: "fault",
    type: /RecursionError/,
    line: 2,
  },
  {
    name: "recursion with a limit of its own, far too high",
    program:
      "import sys\nsys.setrecursionlimit(10**5)\ndef f(n):\n    return f(n + 1) + 1\nprint(f(0))",
    status: "fault",
    type: /RecursionError|MemoryError|SystemError/,
  },
  {
    name: "a deeply nested list, compared",
    mute: true,
    program: "a = []\nb = []\nfor i in range(100000):\n    a = [a]\n    b = [b]\nprint(a == b)",
    status: "fault",
    type: /RecursionError/,
  },
  {
    name: "deeply nested source",
    sample: true,
    program: `x = ${"(".repeat(5000)}1${")".repeat(5000)}`,
    status: "fault",
    mute: true,
    type: /SyntaxError|MemoryError|RecursionError/,
  },
  {
    name: "a long chain of operators",
    program: `x = ${"-".repeat(50000)}1\nprint(x)`,
    status: "fault",
    mute: true,
    type: /SyntaxError|MemoryError|RecursionError/,
  },
  {
    name: "a list that grows without end",
    sample: true,
    program: "kept = []\nwhile True:\n    kept.append(bytearray(50_000_000))",
    status: "fault",
    type: /MemoryError/,
    line: 3,
  },
  {
    name: "one huge allocation",
    program: "x = bytearray(10**12)",
    status: "fault",
    type: /MemoryError|OverflowError/,
    line: 1,
  },
  {
    name: "a text doubled without end",
    program: 'text = "x"\nwhile True:\n    text = text + text',
    status: "fault",
    type: /MemoryError|OverflowError/,
    line: 3,
  },
  {
    name: "a list multiplied beyond memory",
    sample: true,
    program: "grid = [0] * 10**10",
    status: "fault",
    type: /MemoryError|OverflowError/,
    line: 1,
  },
  {
    name: "sys.exit",
    sample: true,
    program: 'import sys\nprint("before")\nsys.exit(3)',
    status: "finished",
    names: 3,
  },
  { name: "os._exit", program: "import os\nos._exit(1)", status: "finished" },
  { name: "os.abort", program: "import os\nos.abort()", status: "finished", names: 2 },
  {
    name: "a null pointer by ctypes",
    sample: true,
    program: "import ctypes\nctypes.string_at(0, 10**10)",
    status: "fault",
  },
  {
    name: "a signal to itself",
    sample: true,
    mute: true,
    program: "import os, signal\nos.kill(os.getpid(), signal.SIGKILL)\nprint('alive')",
    status: "fault",
  },
  {
    name: "BaseException raised by hand",
    program: "raise BaseException('of my own')",
    status: "fault",
    type: /BaseException/,
    line: 1,
  },
  {
    name: "an exception whose text raises",
    sample: true,
    program:
      "class Bad(Exception):\n    def __str__(self):\n        raise ValueError('no text')\nraise Bad()",
    status: "fault",
    type: /Bad/,
    line: 4,
  },
  {
    name: "KeyboardInterrupt raised by hand",
    sample: true,
    program: "raise KeyboardInterrupt",
    status: "stopped",
    names: 1,
  },
  {
    name: "printing without end",
    program: 'while True:\n    print("flood " * 2000)',
    status: "limit",
    says: /print/,
  },
  {
    name: "drawing without end",
    program:
      "from bugbot import *\nn = 0\nwhile True:\n    n += 1\n    draw('m', [(0, 0, 'x' * 500_000 + str(n))], shape='text')",
    status: "limit",
    says: /trace|much|MB/i,
  },
  {
    name: "waiting without end",
    program: "from bugbot import *\nwhile True:\n    wait(10)",
    status: "limit",
    says: /600/,
  },
  {
    name: "a limit that is swallowed",
    sample: true,
    program:
      "from bugbot import *\nwhile True:\n    try:\n        wait(10)\n    except:\n        pass",
    status: "limit",
  },
  {
    name: "builtins torn down",
    sample: true,
    mute: true,
    program: "import builtins\nbuiltins.__dict__.clear()\nprint(1)",
    status: "fault",
    type: /InternalError/,
  },
  {
    name: "sys.stdout taken away",
    program:
      "import sys\nsys.stdout = None\nsys.stderr = None\nprint('gone')\nraise ValueError('x')",
    status: "fault",
    type: /ValueError/,
    line: 5,
  },
  {
    name: "sys.modules cleared",
    sample: true,
    program: "import sys\nsys.modules.clear()\nx = 1 / 0",
    status: "fault",
    type: /ZeroDivisionError/,
    line: 3,
  },
  {
    name: "json taken away from the runtime",
    mute: true,
    program: "import json\njson.dumps = None\njson.JSONEncoder = None\nprint('x')",
    status: "fault",
    type: /InternalError/,
  },
  {
    name: "the trace's own class broken",
    sample: true,
    mute: true,
    program: "import bugbot.trace\nbugbot.trace.Trace.add = None\nfrom bugbot import *\nwait(1)",
    status: "fault",
    type: /InternalError/,
  },
  {
    name: "a trace function that raises",
    program:
      "import sys\ndef spy(*a):\n    raise RuntimeError('spy')\nsys.settrace(spy)\ndef f():\n    return 1\nf()",
    status: "fault",
    type: /RuntimeError/,
  },
  {
    name: "the collector made to raise",
    program:
      "class D:\n    def __del__(self):\n        raise ValueError('in del')\nd = D()\ndel d\nprint('after')",
    status: "finished",
  },
  {
    name: "a null byte in the source",
    program: "x = 1\u0000\nprint(x)",
    status: "fault",
    mute: true,
  },
  {
    name: "half a character",
    program: "print('\\ud800')",
    status: "finished",
  },
  { name: "an empty program", program: "", status: "finished" },
  {
    name: "a program of 1 MB",
    program: `${"x = 1  # a line that says nothing at all\n".repeat(25_000)}print("end")`,
    status: "finished",
  },
];

/** Endless programs that only Stop, or the watch over silence, can end. */
export const ENDLESS: { name: string; program: string; sample?: true }[] = [
  { name: "a bare loop", program: "while True:\n    pass" },
  {
    name: "a loop that prints",
    sample: true,
    program: "n = 0\nwhile True:\n    n += 1\n    print(n)",
  },
  {
    name: "a loop that swallows everything",
    sample: true,
    program: "while True:\n    try:\n        x = 1\n    except BaseException:\n        pass",
  },
  { name: "a loop inside C", sample: true, program: "sum(iter(int, 1))" },
  { name: "a huge power", program: "x = 7 ** (7 ** 12)" },
  {
    name: "a regular expression that explodes",
    program: "import re\nre.match(r'(a+)+$', 'a' * 60 + 'b')",
  },
];
