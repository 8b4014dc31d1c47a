"""What the learner has written, the causes that are told only then, and loops."""

from __future__ import annotations

import pytest
from judged import CELL, failed, marked

from grader.conditions import (
    Condition,
    calls,
    code,
    either,
    lacks,
    number,
    operator,
    reads,
    stores,
)
from grader.failures import AuthorError
from grader.looping import loop_in
from grader.marking import mark_program
from grader.parts import lines_written
from grader.text import Source
from grader.untouched import NOTHING_WRITTEN
from performer.perform import perform

PROGRAM = """
from math import floor as down
import numpy as np

CELL = 10
HALF = CELL / 2

def unused(x):
    return int(x)

def cell_of(x: int, y=-1):
    column = down(x / CELL)
    row = np.ceil(helper(y)) if x <= 8.0 else list(map(round, [y]))
    return column, row

def helper(y):
    heading = 3
    y += 2 ^ heading
    return y // HALF
"""


@pytest.mark.parametrize(
    ("where", "holds"),
    [
        (calls("floor"), True),  # by the name it was imported from
        (calls("ceil"), True),  # as a part of a module
        (calls("round"), True),  # handed on
        (calls("int"), False),  # in an annotation, and in a function that is not used
        (calls("heading"), False),  # a variable
        (reads("HALF"), True),  # by a function that it calls
        (reads("START"), False),
        (stores("column"), True),
        (stores("z"), False),
        (operator("//"), True),
        (operator("^"), True),
        (operator("<="), True),
        (operator("<"), False),
        (number(8), True),
        (number(10), True),  # of the constant that it reads
        (number(3.5), False),
        (code("_ / CELL"), True),
        (code("y / CELL"), False),
        (code("return column, row"), True),
        (lacks(calls("floor")), False),
        (either(reads("START"), reads("CELL")), True),
    ],
)
def test_each_condition(where: Condition, *, holds: bool) -> None:
    assert where(Source(PROGRAM).of("cell_of")) is holds


def test_a_piece_of_code_must_be_one() -> None:
    with pytest.raises(AuthorError, match="wants a piece of code"):
        code("p / ")


STARTER = """CELL = 10

def cell_of(x, y):
    x = int(x)
    # ---- your part ----
    cell = 0, 0
    # ---- end of your part ----
    return cell

print(cell_of(3, round(4.5)))
"""


@pytest.mark.parametrize(
    ("before", "after", "lines"),
    [
        ("cell = 0, 0", "cell = x, 1\n    cell = 7, 8", {5, 6, 7, 8}),
        ("CELL = 10", "CELL = 5", {1, 5, 6, 7}),  # given code that has been changed
        ("    # ---- your part ----\n    cell = 0, 0\n", "    cell = 1, 1\n", {5, 6}),
        ("print(cell_of(3, round(4.5)))\n", "", {5, 6, 7}),
    ],
)
def test_the_lines_that_the_learner_has_written(before: str, after: str, lines: set[int]) -> None:
    assert lines_written(STARTER, STARTER.replace(before, after)) == lines


def test_given_code_does_not_count() -> None:
    text = Source(STARTER.replace("0, 0", "abs(x), 9"), STARTER).of("cell_of")
    assert calls("abs")(text)
    assert not calls("int")(text)
    assert not number(10)(text)
    assert not calls("round")(Source(STARTER.replace("0, 0", "1, 1"), STARTER).of())


@pytest.mark.parametrize("part", ["0, 0", "0,0  # a remark"])
def test_an_untouched_starter_has_made_no_mistake(part: str) -> None:
    check = """
from grader import check, function
f = function("cell_of(x, y)", lambda x, y: (x, y), mistakes=[("0", lambda x, y: (0, 0))])

@check("It")
def it(task):
    for x in range(1, 5):
        task.call(f, x, 1)
"""
    lesson = {"slug": "s", "worlds": {}, "starters": {"task": STARTER}}
    program = STARTER.replace("0, 0", part)
    assert (
        failed(mark_program(check, lesson, "task", program, perform))["likely"] == NOTHING_WRITTEN
    )
    same = STARTER.replace("0, 0", "min(x, 0), 0")
    assert failed(mark_program(check, lesson, "task", same, perform))["likely"] == "0"


INT = CELL.replace(
    '("int() cuts towards 0", lambda', 'mistake("cut towards 0", where=calls("int"), slip=lambda'
).replace("check, function", "calls, check, function, mistake")


def test_a_cause_is_told_only_if_the_learner_has_what_it_names() -> None:
    body = "import math\ndef cell_of(x, y):\n    return {}, {}\n"
    assert failed(marked(INT, body.format("int(x / 10)", "int(y / 10)")))["likely"]
    held = body.format("max(0, math.floor(x / 10))", "math.floor(y / 10)")
    assert failed(marked(INT, held))["likely"] is None


# -- loops -----------------------------------------------------------------------

DEFINE = "import numpy as np\nfrom functools import reduce\ndef f(points, depth=0):\n    {}\n"


@pytest.mark.parametrize(
    ("body", "line", "what"),
    [
        ("for x, y in points: pass", 4, "a for loop"),
        ("while len(points): points = points[1:]", 4, "a while loop"),
        ("return [x for x, _ in points]", 4, "a comprehension"),
        ("return sum(x for x, _ in points)", 4, "a comprehension"),
        ("return [[x, y] for v in (1, 2) for x, y in points]", 4, "a comprehension"),
        ("return list(map(int, points))", 4, "map()"),
        ("return np.vectorize(int)(points)", 4, "vectorize()"),
        ("return np.apply_along_axis(sum, 1, points)", 4, "apply_along_axis()"),
        ("return reduce(max, points)", 4, "reduce()"),
        ("return list(filter(None, points))", 4, "filter()"),
        ("return sorted(points, key=lambda p: p[0] // 5)", 4, "sorted() with a key"),
        ("return [points[:, axis] for axis in range(5)]", 4, "a comprehension"),
        ("return f(points[1:])", 3, "a function that calls itself, f()"),
        ("return g(points)\ndef g(p): return f(p[1:])", 3, "a function that calls itself, f()"),
        ("return g(points)\ndef g(p):\n    for x in p: return x", 6, "a for loop"),
        ("return map(points)\ndef map(p): return [x for x in p]", 5, "a comprehension"),
        ("pts = points.T\n    return [q for q in pts.T]", 5, "a comprehension"),
        ("return [p for p in (*points,)]", 4, "a comprehension"),
    ],
)
def test_a_loop_is_found_in_whatever_form(body: str, line: int, what: str) -> None:
    found = loop_in(Source(DEFINE.format(body)).of("f"))
    assert found is not None
    assert (found[0], found[1][: len(what)]) == (line, what)


@pytest.mark.parametrize(
    "body",
    [
        "return np.floor(points)",
        "return sorted(points)",
        "return [np.floor(v) for v in (points, points)]",
        "return [points[:, axis] for axis in range(2)]",
        "return np.array([c // 5 for c in points.T]).T",
        "return points\nfor each in f([1, 2]): print(each)",  # it only shows
        "map = points\n    return map * 2",
        "return map(points)\ndef map(p): return np.floor(p)",  # the program's own
        "return points\ndef unused(p):\n    return [x for x in p]",
    ],
)
def test_what_goes_through_no_points_is_no_loop(body: str) -> None:
    assert loop_in(Source(DEFINE.format(body)).of("f")) is None


def test_a_vectorized_function_by_another_name_is_a_loop() -> None:
    found = loop_in(Source("import numpy as np\nf = np.vectorize(lambda x: x // 5)\n").of("f"))
    assert found == (2, "vectorize(), which goes through the items one by one")
    assert loop_in(Source("x = (").of("f")) is None


NO_LOOP = """
from grader import check, function
f = function("f(x)", lambda x: x)

@check("Without")
def without(task):
    task.no_loop(f, "do it at once")
"""


def test_a_loop_fails_with_its_line() -> None:
    first = failed(marked(NO_LOOP, "def f(x):\n    for y in x:\n        return y\n"))
    assert first["expected"] == "f without a loop: do it at once"
    assert first["got"].startswith("line 2 has a for loop (only one over at most 4 things ")
    assert marked(NO_LOOP, "def f(x):\n    return x\n\nfor y in [1]:\n    f(y)\n")["passed"]
