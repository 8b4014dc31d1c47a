"""Constants that are changed however they are written, and causes that would not be true."""

from __future__ import annotations

import pytest
from judged import failed, marked

SIZE = """
from grader import check, function

f = function("f(c)", lambda c: c * 4 + 2)

@check("Another size")
def another(task):
    task.set("CELL", 4)
    task.call(f, 3)
"""


@pytest.mark.parametrize(
    "head",
    [
        "\ufeffCELL = 10\nHALF = CELL // 2\n",
        "[CELL, ACROSS] = 10, 20\nHALF = CELL // 2\n",
        "CELL, ACROSS = [10, 20]\nHALF = CELL // 2\n",
        "if True:\n    CELL = 10\nHALF = CELL // 2\n",
        "try:\n    CELL = 10\nfinally:\n    pass\nHALF = CELL // 2\n",
        "for CELL in (10,):\n    pass\nHALF = 2\n",  # no text to change: set before the call
    ],
)
def test_a_constant_is_changed_however_it_is_written(head: str) -> None:
    mark = marked(SIZE, f"{head}def f(c):\n    return c * CELL + HALF\n")
    assert mark["passed"], mark["checks"]


RAISES = """
from grader import check, function

f = function("f(row)", lambda row: 0, mistakes=[("one too far", lambda row: row[len(row)])])

@check("It")
def it(task):
    task.call(f, [1])
"""


def test_an_error_is_a_mistakes_only_in_the_same_words() -> None:
    body = "def f(row):\n    return %s\n"
    assert failed(marked(RAISES, body % "row[1]"))["likely"] == "one too far"
    assert failed(marked(RAISES, body % "'abc'[9]"))["likely"] != "one too far"


NEAR = """
from grader import check, function, near

f = function("f(x)", lambda x: x, compare=near(1), mistakes=[("more", lambda x: x + 0.8)])

@check("It")
def it(task):
    task.call(f, 5)
"""


def test_a_mistake_whose_answer_is_right_explains_none_that_is_wrong() -> None:
    assert failed(marked(NEAR, "def f(x):\n    return x + 1.5\n"))["likely"] is None
