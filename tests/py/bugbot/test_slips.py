"""Common slips: for each a program that makes it, its line, and the cause that is named.

Every program is run, so that the hints hold for the errors Python really raises.
"""

import sys
from collections.abc import Callable
from typing import Any

import numpy as np  # noqa: F401  some programs import it
import pytest

from bugbot.run.slips import likely_cause
from bugbot.run.slips.case import Case, bare_calls

Run = Callable[..., Any]

GOT = sys.version_info >= (3, 14)
"""Whether Python says how many values there were too many."""

SYNTAX = [
    ("x = [1, 2\ny = 3\n", 1, "This [ is never closed"),
    ("draw('a', [(1, 2)]\nwait(1)\n", 1, "This ( is never closed"),
    ("x = 3)\n", 1, "There is a ) too many"),
    ("x = [1, 2)\n", 1, "What was opened with [ is closed with )"),
    ("print(3\nwait 2\n", 1, "This ( is never closed"),
    ("if x == (3:\n    pass\n", 1, None),
    ("for i in range(3)\n    pass\n", 1, "ends with a colon"),
    ("if True\n    pass\n", 1, "ends with a colon"),
    ("def f(x)\n    pass\n", 1, "ends with a colon"),
    ("if x = 3:\n    pass\n", 1, "two equals signs: =="),
    ("while x = 3:\n    pass\n", 1, "two equals signs: =="),
    ("3 = x\n", 1, "stands on the left of ="),
    ("scan() = x\n", 1, "stands on the left of ="),
    ("True = 3\n", 1, "True is a fixed value"),
    ("print('hello)\n", 1, "A quote is missing"),
    ("x = 'it's'\n", 1, "A quote is missing"),
    ("x = '''abc\n", 1, "three quotes"),
    ("x = f'{}'\n", 1, "In an f-text"),
    ("c = 2\nx = (c + 0.5) c\n", 2, "Between ) and c something is missing. To multiply write *"),
    ("c = 2\nx = (c + 0.5)c\n", 2, "Between ) and c something is missing"),
    ("c = 2\nx = ((c + 0.5) c, 3)\n", 2, "Between ) and c something is missing: a comma?"),
    ("c = 2\nx = 2 c + 1\n", 2, "Between 2 and c something is missing"),
    ("c = [2]\nx = c[0] c\n", 2, "Between ] and c something is missing"),
    ("x = 3 4 if\n", 1, None),
    ("x = 1\n  y = 2\n", 2, "further right than the one above"),
    ("if True:\nx = 1\n", 2, "'if' statement on line 1 must be there, indented"),
    ("def f():\n    x = 1\n  y = 2\n", 3, "between two levels"),
    ("if True:\n\tx = 1\n        y = 2\n", 3, "tabs and some with spaces"),
    ("print 'x'\n", 1, "Put brackets round it: print(…)"),
    ("print(“hi”)\n", 1, 'write " instead'),
    ("x = ‘a’\n", 1, "write ' instead"),
    ("x = 5 − 3\n", 1, "− is not the sign on the keyboard: write - instead"),
    ("x = 3×4\n", 1, "write * instead"),
    ("x = 1；\n", 1, "write ; instead"),
    ("x = 3\u00a0+ 4\n", 1, "a space of a special kind"),
    ("turn(90°)\n", 1, "Python has no sign °"),
    ("i = 0\ni++\n", 2, "x += 1"),
    ("if True:\n    pass\nelse if False:\n    pass\n", 3, "one word: elif"),
    ("if True:\n    pass\nelseif False:\n    pass\n", 3, "elif"),
    ("if a && b:\n    pass\n", 1, "the word and"),
    ("if a || b:\n    pass\n", 1, "the word or"),
    ("if !a:\n    pass\n", 1, "the word not"),
    ("function f() {\n}\n", 1, "with def"),
    ("var x = 3\n", 1, "no word before a new name"),
    ("for (i = 0; i < 3; i++)\n", 1, None),
    ("for i = 0\n", 1, "for i in range(10):"),
    ("if x > 3 then:\n    pass\n", 1, "no then"),
    ("for x in [1, 2] do\n    pass\n", 1, "no do"),
    ("if x == 3 {\n    y = 1\n}\n", None, "no { } round a block"),
    ("class = 3\n", 1, "one of Python's own words"),
    ("from = 3\n", 1, "one of Python's own words"),
    ("wait 2\n", 1, "A call needs brackets"),
    ("x = 1\nelse:\n    pass\n", 2, "no if (or try) above it"),
    ("x = 1 +\n", 1, "The line stops too early"),
    ("x =\n", 1, "The line stops too early"),
    ("return 3\n", 1, "return belongs inside a function"),
    ("break\n", 1, "break belongs inside a loop"),
    ("x = (1 2)\n", 1, "there must be a comma"),
    ("drive(50, 0 0)\n", 1, "there must be a comma"),
    ("x = 007\n", 1, "does not begin with 0"),
    ("x = 5cm\n", 1, "units like cm"),
    ("f(a=1, 2)\n", 1, "come after those without"),
    ("def f:\n    pass\n", 1, "def needs brackets"),
    ("x = {1: 2, 3}\n", 1, "key: value"),
    ("try:\n    x = 1\ny = 2\n", None, "try needs an except"),
    ("def f():\n    x = 1\n    global x\n", 3, "must come first"),
    ("def f(a, a):\n    pass\n", 1, "Two arguments are called a"),
    ("x = \\ 3\n", 1, "There is a \\ in the line"),
    ("```python\n", 1, "the lines with ```"),
    (">>> x = 3\n", 1, "Leave out the >>>"),
    ("x = ?\n", 1, None),
    (
        "for angle distance in scan():\n    pass\n",
        1,
        "there must be a comma: for angle, distance_cm",
    ),
    ("if d > 3 and < 5:\n    pass\n", 1, "needs both its values"),
    ("x = 2y\n", 1, "to multiply write *: 2 * x"),
    (
        "grid = [0] * 4\u200b\n",
        1,
        "invisible character at position 15 of the line, a zero width space",
    ),
    ("x = 4\nab\u00adc = 5\n", 2, "invisible character at position 3 of the line, a soft hyphen"),
    ("x = 4\nx\ufeff = 5\n", 2, "a zero width no-break space (U+FEFF)"),
    (
        "x = 3\u2009+ 4\n",
        1,
        "There is a thin space at position 6 of the line, a space of a special kind",
    ),
    (
        "f\u043er i in range(3):\n    pass\n",
        1,
        "In f\u043er the \u043e is a Cyrillic small letter o",
    ),
    ("... y = 2\n", 1, "Leave out the ... at the start of the line"),
    ("In [ ]: for i in range(3):\n", 1, "it is a notebook's prompt"),
    ("!pip install numpy\n", 1, "Nothing can be installed here"),
    ("%pip install numpy\n", 1, "Nothing can be installed here"),
    ("pip install matplotlib\n", 1, "This is a command for a terminal"),
    ("$ python program.py\n", 1, "This is a command for a terminal"),
    ("python3 -m bugbot run program.py\n", 1, "This is a command for a terminal"),
    ("%matplotlib inline\n", 1, "%matplotlib is a command of a notebook"),
    ("%%time\nx = 3\n", 1, "%%time is a command of a notebook"),
    ("x = 10\ny = (x\n% 3 +)\n", None, None),
]

NAMES = [
    ("x = true\n", 1, "In Python this is written True."),
    ("x = null\n", 1, "In Python this is written None."),
    ("sleep(1)\n", 1, "In Python this is written wait."),
    ("wait(1)\n", 1, "at the top of the program: from bugbot import *"),
    ("Robot()\n", 1, "at the top of the program: from bugbot import *"),
    ("import bugbot\nwait(1)\n", 2, "write bugbot.wait"),
    ("x = math.pi\n", 1, "at the top of the program: import math"),
    ("x = np.zeros(3)\n", 1, "at the top of the program: import numpy as np"),
    ("x = sin(3)\n", 1, "at the top of the program: from math import sin"),
    ("import math\nx = sin(3)\n", 2, "write math.sin"),
    ("x == 5\n", 1, "To give x a value write one equals sign: x = …"),
    ("go_on()\ndef go_on():\n    pass\n", 1, "first gets its value on line 2"),
    ("print(total)\ntotal = 3\n", 1, "first gets its value on line 2"),
    ("from bugbot import *\nfoward(50)\n", 2, "Did you mean forward?"),
    (
        "from bugbot import *\nForward(50)\n",
        2,
        "Did you mean forward? Capital and small letters count.",
    ),
    (
        "foward(50)\n",
        1,
        "Did you mean forward? It needs this line at the top: from bugbot import *",
    ),
    ("Print(3)\n", 1, "Did you mean print? Capital and small letters count."),
    ("known = 3\nprint(knwon)\n", 2, "It is spelt known on line 1 and knwon on line 2: make"),
    (
        "known = 3\nprint(known)\nprint(knwon)\n",
        3,
        "It is spelt known on lines 1 and 2 and knwon on line 3: make them the same.",
    ),
    (
        "def regions(x):\n    return x\nregions(1)\nlarge_regions(1)\n",
        4,
        "Did you mean regions?",
    ),
    (
        "def cell_of(x):\n    colum = x\n    colum += 1\n    return column\ncell_of(3)\n",
        4,
        "It is spelt colum on lines 2 and 3 and column on line 4: make them the same.",
    ),
    (
        "def cell_of(x):\n    colum = x // 5\n    return column\ncell_of(3)\n",
        3,
        "It is spelt colum on line 2 and column on line 3: make them the same.",
    ),
    (
        "colum = 3\nif column > 3:\n    print(column)\n",
        2,
        "It is spelt colum on line 1 and column on lines 2 and 3: make them the same.",
    ),
    (
        "class A:\n    def __init__(self):\n        self.colum = 3\nprint(A().column)\n",
        4,
        "It is spelt colum on line 3 and column on line 4: make them the same.",
    ),
    (
        "t = {'colum': 3}\nprint(t['column'])\n",
        2,
        "It is spelt 'colum' on line 1 and 'column' on line 2: make them the same.",
    ),
    ("\u0430ngle = 3\nprint(angle)\n", 2, "on line 1 the \u0430 is a Cyrillic small letter a"),
    ("angle = 3\nprint(angl\u0435)\n", 2, "on line 2 the \u0435 is a Cyrillic small letter ie"),
    ("x = [0] * hello_there\n", 1, "Nothing is called hello_there here. A text needs quotes"),
    ("class A:\n    def f():\n        self.x = 1\nA.f()\n", 3, "takes self as its first argument"),
    ("n = 0\ndef f():\n    n += 1\nf()\n", 3, "begin the function with: global n"),
    (
        "def f():\n    if False:\n        n = 1\n    return n\nf()\n",
        4,
        "n gets its value on line 3, inside the if of line 2, and the function has not come by "
        "there: give it one before that if as well.",
    ),
    (
        "def f(rows):\n    for r in rows:\n        n = r\n    return n\nf([])\n",
        4,
        "n gets its value on line 3, inside the for of line 2",
    ),
    (
        "def f():\n    if n > 2:\n        n = 2\nf()\n",
        2,
        "Nothing has given n a value before line 3 yet: give it one above this line.",
    ),
    (
        "n = 5\ndef f(x):\n    if x:\n        n = 1\n    return n\nf(0)\n",
        5,
        "n gets its value on line 4, inside the if of line 3",
    ),
    ("n = 5\ndef f():\n    n += 1\nf()\n", 3, "begin the function with: global n"),
    ("def f():\n    n += 1\nf()\n", 2, "Nothing has given n a value yet"),
    (
        "def f(x):\n    if x:\n        for i in []:\n            n = i\n        print(n)\nf(1)\n",
        5,
        "inside the for of line 3",
    ),
    ("x = [1]\nx.push(2)\n", 2, "For a list this is append."),
    ("x = [1]\nx.apend(2)\n", 2, "Did you mean append?"),
    ("x = None\nx.append(2)\n", 2, "The value before the dot is None"),
    ("import bugbot\nbugbot.wiat(2)\n", 2, "Did you mean wait?"),
    ("from bugbot import *\nr = Robot()\nr.foward()\n", 3, "Did you mean forward?"),
    ("from bugbot import *\nposition.x\n", 2, "call it with brackets: position()"),
    ("from bugbot import *\nposition().x\n", 2, "x, y = position()"),
    ("x = 3\nx.qqq\n", 2, None),
    ("move(50)\n", 1, "This robot's call for it is forward(50)."),
    ("robot.forward(50)\n", 1, "Put this line above: robot = connect()."),
    (
        "from bugbot import *\nconnect().jump()\n",
        2,
        "The robot's calls are backward, battery, beep",
    ),
    ("import time\ntime.wait(1)\n", 2, "wait() is the robot's own call: leave out time."),
    ("s = set()\ns.append(1)\n", 2, "For a set this is add."),
    ("s = {}\ns.add(1)\n", 2, "An empty set is set()"),
    ("import numpy as np\nnp.zeros(3).append(1)\n", 2, "An array keeps its size"),
    ("class A:\n    def f(self):\n        self.x = 1\nA.x\n", 4, "A is the class: A() makes"),
    ("class A:\n    def __init__(self):\n        cells = {}\nA().cells\n", 4, "self.cells = …"),
    ("from math import sqrt\nsqr(4)\n", 2, "Did you mean sqrt?"),
    ("import mathh\n", 1, "Did you mean math?"),
    ("import Bugbot\n", 1, "Did you mean bugbot? Capital and small letters count."),
    ("import pandas\n", 1, "pandas can't be had here: numpy has arrays."),
    ("import matplotlib.pyplot as plt\n", 1, "plot(name, value) makes a chart."),
    ("import cv2\n", 1, "a map is an array of numpy"),
    ("import rospy\n", 1, "the robot's calls are in bugbot: from bugbot import *"),
    ("import requests_of_mine\n", 1, "Python's own library (math, random, …), bugbot and numpy"),
    ("from grid import Grid\n", 1, "If grid is a file of yours: a program here is one file"),
    ("import my.grid\n", 1, "If my is a file of yours: a program here is one file"),
    ("from .grid import Grid\n", 1, "A program here is one file"),
    ("from . import grid\n", 1, "A program here is one file"),
    ("from bugbot import foward\n", 1, "Did you mean forward?"),
    ("from math import sinus\n", 1, None),
    ("raise ModuleNotFoundError('no tkinter', name='tkinter')\n", 1, "draws on the mat"),
    ("raise ModuleNotFoundError('no ssl', name='ssl')\n", 1, "can't be had in a browser"),
    ("In [1]: print(1)\n", 1, "Leave out the In [1]: at the start of the line"),
    ("x = 3\nOut[3]: x\n", 2, "Leave out the Out[3]: at the start of the line"),
    ("raise ModuleNotFoundError('no numpy', name='numpy')\n", 1, "python -m pip install numpy"),
    ("raise NameError\n", 1, None),
    ("raise AttributeError\n", 1, None),
    ("raise UnboundLocalError('strange')\n", 1, "Nothing has given it a value"),
]

CALLS_ = [
    ("for a, d in scan:\n    pass\n", "scan is a function: to use what it gives, call it"),
    ("if distance < 20:\n    stop()\n", "distance is a function"),
    ("x, y = position\n", "position is a function"),
    ("x = heading + 90\n", "heading is a function"),
    ("x = scan[0]\n", "scan is a function"),
    ("import math\nx = math.sin(heading)\n", "heading is a function"),
    ("wait(clock)\n", "clock is a function"),
    ("x = len + 1\n", "len is a function"),
    ("x = (lambda: 3) + 1\n", None),
    (
        "distance = distance()\nwait(1)\ndistance = distance()\n",
        "the robot's call distance() is covered up",
    ),
    ("x = [1, 2]\nprint(x(0))\n", "use square brackets: x[…]"),
    (
        "x = 3\nx()\n",
        "x is a value of type int, and that can't be called. To multiply write *: x * (…)",
    ),
    ("x = 3 * 2.5\ny = (x)(x + 1)\n", "A bracket right after another bracket makes a call of it"),
    ("x = 3\ny = 2(x)\n", "A bracket right after a number makes a call of it. To multiply write *"),
    ("x = [3]\ny = x[0](2)\n", "A bracket right after another bracket makes a call of it"),
    ("@(lambda f: 3)\ndef f():\n    pass\nclass A:\n    b = 3\nA.b(2)\n", None),
    (
        "def turned(x):\n    return x\nturned = 2.5\ny = turned(3)\n",
        "sets turned to a value of type float, so the function of that name is gone",
    ),
    (
        "def n(x):\n    return x\nfor n, m in [(1, 2)]:\n    y = n(3)\n",
        "sets n to a value of type int, so the function of that name is gone",
    ),
    ("y = [(1, 2) (3, 4)]\n", "a comma missing"),
    ("for d in scan():\n    a, b, c = d\n", "The 3 names on the left get 2 values."),
    ("a, b = [1]\n", "The 2 names on the left get 1 value."),
    ("a, b, *c = [1]\n", "The names on the left want at least 2 values and get 1."),
    ("(a,) = 'ab'\n", "1 name on the left"),
    ("a, b = [1, 2, 3]\n", "The 2 names on the left get 3" if GOT else "more values than the 2"),
    ("for a, b, c in scan():\n    pass\n", "scan() gives 8 pairs"),
    ("a, d = scan()\n", "scan() gives 8 pairs"),
    ("x, y, h = position()\n", "position() gives two numbers"),
    ("x, y = odometry()\n", "odometry() gives three numbers"),
    ("x, y = distance()\n", "can be taken apart"),
    ("if scan() < 20:\n    stop()\n", "scan() gives 8 pairs"),
    ("x = position() + 1\n", "position() gives two numbers"),
    ("x = [1] + 1\n", None),
    ("draw('a', [], color='red')\n", "It is spelt colour here."),
    ("draw('a', [], colur='red')\n", "Did you mean colour?"),
    ("draw('a', [], qqq='red')\n", None),
    ("forward(50, time=3)\n", "To go on for a time: forward(50) and then wait(3)."),
    ("turn('left')\n", "turn(90) is to the right, turn(-90) to the left."),
    ("turn(left, 90)\n", "turn(90) is to the right, turn(-90) to the left."),
    ("turn(90, speed=-30)\n", "turn(90) is to the right, turn(-90) to the left."),
    ("t = {'a': 1}\nfor k, v in t:\n    pass\n", "for key, value in t.items():"),
    ("import numpy as np\ngrid = np.zeros((4, 4))\ngrid(1, 2)\n", "grid is an array: to take"),
    ("def f(x):\n    pass\nf(qqq=1)\n", "f is defined on line 2: def f(x):"),
    ("wait('2')\n", "A number is written without quotes"),
    ("def f():\n    pass\nx = f() + 1\n", "Something here is None"),
    ("x = [3, 1].sort()\nfor y in x:\n    pass\n", "Something here is None"),
    ("wait(print())\n", "Something here is None"),
    ("class A:\n    def f():\n        pass\nA().f()\n", "The method f needs self"),
    ("def f(x, y):\n    pass\nf(1)\n", "f is defined on line 2: def f(x, y):"),
    ("f = lambda x: x\nf()\n", None),
    ("int('3', base=10, other=3)\n", None),
    ("def f(n):\n    return f(n + 1)\nf(0)\n", "needs an if that ends it"),
    ('raise RuntimeError("can\'t start new thread")\n', "no threads here"),
]

VALUES = [
    (
        "grid = [0] * 1600\ngrid[1600] = 1\n",
        "grid has 1600 items, with the indices 0 to 1599. The first index is 0.",
    ),
    ("grid = [0] * 9\nr = c = 3\nx = grid[r * 3 + c]\n", "has the index row * columns + column"),
    ("x = []\nprint(x[0])\n", "x is empty. The first index is 0."),
    ("x = 'a'\nprint(x[1])\n", "x has 1 character. The first index is 0."),
    ("x = [].pop()\n", "There is nothing left in it"),
    ("raise IndexError\n", None),
    ("import numpy as np\ng = np.zeros((4, 4))\ng[102.5 / 5, 0] = 1\n", "math.floor(…)"),
    ("import numpy as np\ng = np.zeros((4, 4))\nx = g[2.0]\n", "is a whole number"),
    (
        "import numpy as np\ng = np.zeros((4, 5))\nx = g[1, 5]\n",
        "Along axis 1 the indices go from 0 to 4.",
    ),
    (
        "import numpy as np\ng = np.zeros(4)\nx = g[1, 2]\n",
        "The array has 1 axis, and here it is given 2.",
    ),
    ("import numpy as np\ng = np.zeros(4.0)\n", "A whole number is wanted here"),
    ("x = [1, 2][3]\n", "The first index is 0."),
    ("grid = [0] * 10\nx = grid[10 / 5]\n", "use // to divide"),
    ("x = [1, 2][0.5:]\n", "use // to divide"),
    ("for i in range(200 / 5):\n    pass\n", "A whole number is wanted here: use // to divide"),
    ("grid = [[0]]\nx = grid[0, 0]\n", "grid[row][column]"),
    ("x = [1]['a']\n", "A list is asked by number"),
    ("x = 'a' + 3\n", "can't be added"),
    ("x = 3 + 'a'\n", "One side is a text"),
    ("x = 'a' - 3\n", "One side is a text"),
    ("x = '3' < 4\n", "One side is a text"),
    ("for d in distance():\n    pass\n", "This is a single number, not a list"),
    ("for i in 8:\n    pass\n", "for i in range(…):"),
    ("x = distance()[0]\n", "it has no parts"),
    ("x = len(3)\n", "This is a single number, not a list."),
    ("x = 1 / 0\n", "Nothing can be divided by 0."),
    ("p = 1.0\nx = p / (1 - p)\n", "1 - p is 0 here: ask with if before dividing."),
    ("n = 0\nx = 5\nx /= n\n", "n is 0 here"),
    ("a = b = 0\nx = 1 / (2 / 1 - 2) + 3 / b\n", "Something here is divided by 0"),
    ("x = divmod(3, 0)\n", "Something here is divided by 0"),
    ("x = 0.0 ** -1\n", "0 has no negative power"),
    ("x = 1 // 0.0\n", "Nothing can be divided by 0."),
    ("x = 1 % 0\n", "Nothing can be divided by 0."),
    ("import math\nx = math.log(0)\n", "log() only works for numbers above 0"),
    ("import math\np = 0.0\nx = math.log(p / (1 - p))\n", "log() only works for numbers above 0"),
    ("import math\nx = math.sqrt(-1)\n", "sqrt() only works for numbers from 0 up"),
    ("from math import acos\nx = acos(2)\n", "acos() only works for numbers from -1 to 1"),
    ("import math\nx = math.log(math.sqrt(-1))\n", "log() wants more than 0, sqrt() 0 or more"),
    (
        "import math\np = 0.7\nx = math.log(p / 1 - p)\n",
        "so p / 1 - p is p - p. Put brackets round what you divide by: p / (1 - p)",
    ),
    (
        "import math\np = [0.7]\nx = math.log(p[0] / 1 - p[0])\n",
        "Put brackets round what you divide by: p[0] / (1 - p[0])",
    ),
    ("import math\nx = math.exp(1000)\n", "The number gets too large"),
    ("plot('a', float('inf') - float('inf'))\n", "nan and inf come from sums without an answer"),
    ("draw('a', [(1, float('nan'))])\n", "nan and inf come from sums without an answer"),
    ("draw('goal', (100, 150))\n", "A single point needs square brackets"),
    ("draw('goal', [[100, 150, 3]])\n", "Every point is a pair in brackets"),
    ("table = {'free': 1}\nx = table['fre']\n", "It is spelt 'free' on line 2 and 'fre' on line 3"),
    (
        "x = {'free': 1}\nx['free'] += 1\nprint(x['fre'])\n",
        "make them the same",
    ),
    ("table = {(0, 1): 1}\nx = table[0, 2]\n", "table.get(key, 0)"),
    ("x = int('3 cm')\n", "something else than a number"),
    ("x = int('5.5')\n", "int() reads whole numbers only"),
    ("x = float(' ')\n", "The text is empty."),
    ("draw('goal', 100, 150)\n", "draw() wants a list of them"),
    ("s = {[1, 2]}\n", "A list can't be in a set or be a key: use a tuple"),
    ("t = {{1}: 2}\n", "use frozenset(…)"),
    ("x = scan()\nif x[0] < 20:\n    pass\n", "One side is a tuple, several values at once"),
    ("for d in scan():\n    if d < 50:\n        stop()\n", "take one of them, like pair[1]"),
    ("x = (3, 5) + 1\n", "With a comma, 3,5 is one as well: 3.5"),
    ("x = [0] * 2.5\n", "A whole number is wanted here"),
    ("x = '3' * '4'\n", "A text or a list can only be repeated"),
    ("import random\nx = random.randint(0, 5.5)\n", "A whole number is wanted here"),
    (
        "import numpy as np\nx = np.zeros(4, 4)\n",
        "in brackets of its own: np.zeros((rows, columns))",
    ),
    ("import numpy as np\nx = np.array([1, 2], [3, 4])\n", "np.array([[1, 2], [3, 4]])"),
    ("import numpy as np\nx = np.zeros(3) + np.zeros(4)\n", "print the shape of each"),
    ("x = float('wide')\n", "something else than a number"),
    ("t = {1: 2}\nfor k in t:\n    t[k + 1] = 3\n", "go through list(…) of it"),
    ("import numpy as np\nif np.zeros(3) == 0:\n    pass\n", "(…).any() or (…).all()"),
    ("import numpy as np\na = np.zeros(3)\nx = a >= 0 and a < 2\n", "like (a > 0) & (b < 9)."),
    ("import numpy as np\na = np.zeros(3)\nx = a < 0 or a > 2\n", "like (a > 0) | (b < 9)."),
    (
        "import numpy as np\na = np.zeros(3)\nif a >= 0 and a < 2:\n    pass\n",
        "with .any() or .all().",
    ),
    ("import numpy as np\na = np.zeros(3)\nx = 0 < a < 2\n", "like (a < b) & (b < c)."),
    ("import numpy as np\na = np.zeros(3)\nx = not a\n", "write ~ in its place"),
    ("import numpy as np\na = np.zeros(3)\nx = max(a, 2)\n", "it is np.maximum(a, b)"),
    ("x = [0] * 10**14\n", "grow without end"),
    ("x = [0] * 10**40\n", "grow without end"),
    ("raise ValueError('something else')\n", None),
    ("raise KeyError\n", None),
]


@pytest.mark.parametrize(("program", "line", "hint"), SYNTAX, ids=[row[0] for row in SYNTAX])
def test_slips_in_what_can_not_be_read(run: Run, program: str, line: int, hint: str | None) -> None:
    ran = run(program)
    assert ran.status == "fault"
    assert ran.fault["type"] in ("SyntaxError", "IndentationError", "TabError")
    if line is not None:
        assert ran.fault["line"] == line
    if hint is not None:
        assert hint in str(ran.fault["hint"])


@pytest.mark.parametrize(("program", "line", "hint"), NAMES, ids=[row[0] for row in NAMES])
def test_slips_in_names(run: Run, program: str, line: int, hint: str | None) -> None:
    ran = run(program)
    assert ran.fault["line"] == line
    assert hint in ran.fault["hint"] if hint else ran.fault["hint"] is None


WITH_CALLS = CALLS_ + VALUES


@pytest.mark.parametrize(("program", "hint"), WITH_CALLS, ids=[row[0] for row in WITH_CALLS])
def test_slips_in_calls_and_values(run_calls: Run, program: str, hint: str | None) -> None:
    ran = run_calls(program)
    assert ran.status == "fault"
    assert ran.fault["line"] is not None
    assert hint in str(ran.fault["hint"]) if hint else ran.fault["hint"] is None


@pytest.mark.parametrize(
    ("program", "message"),
    [
        ("drive(50)", "drive(forward, right, turn) wants 3 arguments; right and turn are missing"),
        (
            "drive()",
            "drive(forward, right, turn) wants 3 arguments; forward, right and turn are missing",
        ),
        ("wait()", "wait(seconds) wants 1 argument; seconds is missing"),
        ("wait(1, 2)", "wait(seconds) wants 1 argument; it got 2"),
        ("forward(1, 2, 3)", "forward(speed, distance) wants at most 2 arguments; it got 3"),
        (
            "draw('a')",
            "draw(name, points, colour, shape, size) wants 2 arguments; points is missing",
        ),
        ("scan(5)", "scan() wants no arguments; it got 1"),
        ("Robot().scan(5)", "scan() wants no arguments; it got 1"),
        ("wait(s=1)", "wait(seconds) has no argument called s"),
        (
            "turn(90, degrees=3)",
            "turn(degrees, speed) got degrees twice: once by its place and once by its name",
        ),
    ],
)
def test_wrong_numbers_of_arguments_are_told_in_plain_words(
    run_calls: Run, program: str, message: str
) -> None:
    ran = run_calls(program)
    assert (ran.fault["type"], ran.fault["message"], ran.fault["line"]) == ("TypeError", message, 2)


def test_a_function_of_ones_own_keeps_pythons_words(run: Run) -> None:
    ran = run("def turn():\n    pass\nturn(90)")
    assert ran.fault["message"] == "turn() takes 0 positional arguments but 1 was given"
    assert ran.fault["hint"] == "turn is defined on line 1: def turn():"


def test_python_complaining_oddly_of_a_call_is_passed_on(run_calls: Run) -> None:
    ran = run_calls("raise TypeError('wait() takes it badly')")
    assert ran.fault["message"] == "wait() takes it badly"


# -- quiet slips ---------------------------------------------------------------


@pytest.mark.parametrize(
    ("program", "remark"),
    [
        ("forward(50)", "The robot was told to move, but no time passed"),
        ("drive(10, 0, 0)\nstop()", "The robot was told to move, but no time passed"),
        ("import math\nturn(math.pi / 2)", "Line 3: turn(1.5708) is a turn of 1.5708 degrees."),
        ("import math\nturn(-math.radians(30))", "Line 3: turn(-0.5236) is a turn of"),
        ("forward\nwait(1)", "Line 2: forward does nothing without its brackets: forward()"),
        ("x = 3\nx == 4", "Line 3 only compares"),
        ("import math\nwait(1)\nx = math.sin(heading())", "Line 4: sin() wants radians"),
        ("from math import cos\nh = heading()\nx = cos(h)", "Line 4: cos() wants radians"),
        ("from math import cos\nx, y, h = odometry()\nx = cos(h)", "Line 4: cos() wants radians"),
        (
            "from math import sin\nfor angle, d in scan():\n    x = sin(angle)",
            "Line 4: sin() wants radians",
        ),
        (
            "print(position)",
            "Line 2 prints the function position itself: what it gives is position()",
        ),
        ("def go():\n    pass\ngo", "Line 4: go does nothing without its brackets: go()"),
        ("n = 3\nn =+ 1", "Line 3: =+ gives n a new value. To add to the old one write +="),
        ("draw('wall', scan())", "Line 2: scan() gives angles and distances"),
        ("forward(0.5)\nwait(1)", "0.5 of full speed is forward(50)."),
    ],
)
def test_programs_that_finish_and_yet_missed_something(
    run_calls: Run, program: str, remark: str
) -> None:
    ran = run_calls(program)
    assert ran.status == "finished"
    assert ran.message.startswith("Finished after ")
    assert remark in ran.message


@pytest.mark.parametrize(
    "program",
    [
        "forward(50)\nwait(1)",
        "stop()",
        "turn(1)\nturn(45)\nturn(3.5)\nturn(0)",
        "forward = 3\nforward",
        "from math import sin, radians\nx = sin(radians(heading()))",
        "from math import sin\nh = 3\nx = sin(h)",
        "x = [sin for sin in (1, 2)]\nx[0]",
        "def sin():\n    return 1\nx = sin() + (lambda: 1)()",
        "1 if clock() == 0 else 2",
        "from math import radians, sin\nh = heading()\nh = radians(h)\nx = sin(h)",
        "from math import radians, sin\nheading = radians(heading())\nx = sin(heading)",
        "from math import sin\nfor angle, d in scan():\n    angle /= 57.3\n    x = sin(angle)",
        "position = 3\nprint(position)",
        "forward(1)\nforward(0.0)\nwait(1)",
    ],
)
def test_sound_programs_get_no_remark(run_calls: Run, program: str) -> None:
    ran = run_calls(program)
    assert ran.message == f"Finished after {round(ran.seconds, 2):g} s."


def test_only_a_few_remarks_are_made(run_calls: Run) -> None:
    ran = run_calls("forward\n" * 10)
    assert ran.message.count("does nothing without") == 3


def test_a_very_long_program_is_not_read_through(run_calls: Run) -> None:
    assert run_calls("forward\n" + "x = 1\n" * 40_000).message == "Finished after 0 s."


def test_a_turn_outside_any_line_is_remarked_on_without_one(run: Run) -> None:
    ran = run("from bugbot import turn\nexec('turn(3.141592653589793)')")
    assert "Line 2: turn(3.1416)" in ran.message


# -- the case ------------------------------------------------------------------


def case(text: str, **scope: object) -> Case:
    return Case(TypeError("x"), "x", 1, [text], scope, "program.py")


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("f(g)", ["g"]),
        ("x = f + g  # h", ["f", "g"]),
        ("x = 'f' + \"g\" + h", ["h"]),
        ("f = 3", []),
        ("f == g", ["f", "g"]),
        ("a.f + h", ["h"]),
        ("f.g()", []),
        ("for x in f:", ["f"]),
        ("kind", []),
    ],
)
def test_bare_calls_are_functions_named_without_brackets(text: str, names: list[str]) -> None:
    scope = dict.fromkeys("fgh", print)
    assert bare_calls(case(text, **scope, kind=int)) == names


def test_a_case_without_a_line_has_no_text() -> None:
    nowhere = Case(TypeError("x"), "x", None, ["a"], {}, "program.py")
    assert nowhere.text == ""
    assert nowhere.text_of(2) == ""
    assert likely_cause(nowhere) is None


def test_python_does_not_speak_of_a_comma_where_a_sign_is_missing(run: Run) -> None:
    ran = run("x = 3\ny = 2(x)")
    assert ran.console == ""
