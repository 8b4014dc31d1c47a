"""Answers of another kind than is asked, None, and programs that end early."""

from __future__ import annotations

import pytest
from judged import CELL, RIGHT, failed, marked, statuses

HEAD = """import math
from decimal import Decimal
from dataclasses import dataclass

@dataclass
class Cell:
    column: int
    row: int

"""
COUNTED = "item 0 (counted from 0)"


@pytest.mark.parametrize(
    ("body", "likely"),
    [
        ("return Cell(3, 7)", "it is a Cell; the task asks for a tuple of 2, such as (3, 7)"),
        ("return {'x': 3}", "it is a dict; the task asks for a tuple of 2"),
        ("return float('nan'), 3", f"{COUNTED} is nan, which comes from sums without an answer"),
        ("return math.inf, 3", f"{COUNTED} is infinite"),
        ("return object(), 3", f"{COUNTED} is an object; the task asks for a whole number"),
        ("return Decimal(int(x // 10)), y // 10", "the numbers are right, but they are Decimals"),
        ("return '37'", "it is a text, '37'; the task asks for a tuple of 2, such as (3, 7)"),
        ("return '3', '7'", f"{COUNTED} is a text, '3'; the task asks for a whole number"),
        ("return True, 7", f"{COUNTED} is True; the task asks for a whole number"),
        ("return True", "it is True; the task asks for a tuple of 2"),
        ("return 3", "it is a whole number; the task asks for a tuple of 2"),
        ("return {3, 7}", "it is a set, which has no order; the task asks for a tuple of 2"),
        ("return enumerate([3])", "it is an enumerate, which is no tuple yet: put tuple()"),
        ("yield 3\n    yield 7", "cell_of has a yield, so calling it gives a generator"),
        ("return math.floor", "it returns a function itself"),
        ("return [1, 2, 3]", "it gives the same answer whatever it is asked"),
    ],
)
def test_the_kind_that_is_asked_and_given_is_told(body: str, likely: str) -> None:
    first = failed(marked(CELL, f"{HEAD}def cell_of(x, y):\n    {body}\n"))
    assert first["likely"].startswith(likely)


def test_an_async_function_is_told() -> None:
    first = failed(marked(CELL, "async def cell_of(x, y):\n    return 3, 7\n"))
    assert first["likely"].startswith("cell_of is an async function")


ONE = """
from grader import check, function

f = function("f(x)", lambda x: [x])

@check("It")
def it(task):
    task.call(f, 3)
"""
ANY_ORDER = ONE.replace("[x])", "[x], compare=in_any_order)").replace(
    "function\n", "function, in_any_order\n", 1
)


def test_a_set_is_no_mistake_where_the_order_does_not_matter() -> None:
    assert marked(ANY_ORDER, "def f(x):\n    return {x}\n")["passed"]
    assert failed(marked(ANY_ORDER, "def f(x):\n    return {x + 1}\n"))["likely"] is None
    told = failed(marked(ONE, "def f(x):\n    return {x + 1}\n"))["likely"]
    assert told == "it is a set, which has no order; the task asks for a list"


NO_RETURN = "a function hands back its answer with return, and this one has no return"


@pytest.mark.parametrize(
    ("body", "likely"),
    [
        ("y = x", NO_RETURN),
        ("return", NO_RETURN),
        ("def g():\n        return 1\n    g()", NO_RETURN),
        ("print([x])", "it prints its answer instead of returning it"),
        (
            "print(x)\n    if x > 5:\n        return [x]",
            "it reached its end without a return: line 3 was the last to run",
        ),
        ("if x > 3:\n        return [x]\n    return", "the return on line 4 has nothing after it"),
        ("if x > 3:\n        return [x]\n    return None", None),
        ("return [].append(x)", "line 2 returns what append() gives, and that is None"),
        ("return print(x)", "print() itself gives None, and line 2 returns just that"),
        ("return {}.get(x)", None),
    ],
)
def test_none_is_explained_by_what_happened(body: str, likely: str | None) -> None:
    first = failed(marked(ONE, f"def f(x):\n    {body}\n"))
    assert first["got"] == "f(3) returned None"
    if likely is None:
        assert first["likely"] is None
    else:
        assert first["likely"].startswith(likely)


WRONG = "def cell_of(x, y):\n    return 0, 0\n"


@pytest.mark.parametrize(
    "rest",
    [
        "from bugbot import *\nwhile True:\n    wait(1)\n",
        "while True:\n    print('x' * 1000)\n",
        "exit()\n",
        "1 / 0\n",
    ],
)
def test_the_functions_are_judged_whatever_ends_the_code_that_shows_them(rest: str) -> None:
    assert failed(marked(CELL, WRONG + rest))["got"] == "(0, 0)"


def test_a_program_that_leaves_after_its_functions_passes() -> None:
    assert marked(CELL, f"{RIGHT}exit()\n")["passed"]
    late = marked(CELL, f"exit()\n{RIGHT}")
    assert failed(late)["got"] == "Finished after 0 s: the program left on line 1."


def test_a_program_without_an_end_fails_once_its_functions_are_right() -> None:
    mark = marked(CELL, f"{RIGHT}from bugbot import *\nwhile True:\n    wait(1)\n")
    assert failed(mark)["expected"] == "a program that comes to its end"
    assert statuses(mark) == ["failed", "not run"]


def test_a_wrong_answer_of_a_later_check_counts_before_the_code_that_breaks_on_it() -> None:
    half = "def cell_of(x, y):\n    if x > 0:\n        return x // 10, y // 10\n"
    mark = marked(CELL, f"{half}\ncolumn, row = cell_of(-5, 15)\n")
    assert statuses(mark) == ["passed", "failed"]
    assert failed(mark)["got"] == "cell_of(-5, 15) returned None"
    right = marked(CELL, f"{RIGHT}\ncolumn, row = 3\n")
    assert statuses(right) == ["failed", "not run"]
    assert failed(right)["got"].startswith("TypeError on line 5")


MAYBE = """
from grader import check, function

f = function("f(x)", lambda x: x if x > 2 else None)

@check("It")
def it(task):
    task.call(f, 3)
    task.call(f, 1)
"""


def test_where_none_can_be_right_no_return_is_asked_for_on_every_road() -> None:
    assert failed(marked(MAYBE, "def f(x):\n    if x > 5:\n        return x\n"))["likely"] is None


def test_a_function_by_another_name_is_missed_though_the_code_that_shows_it_stops() -> None:
    first = failed(marked(CELL, "def cells_of(x, y):\n    return 3, 7\n\nprint(cell_of(3, 7))\n"))
    assert first["expected"] == "a function cell_of(x, y)"
    assert first["likely"].startswith("the program has cells_of")
    early = failed(marked(CELL, f"print(cell)\n{RIGHT}"))
    assert early["got"].startswith("NameError on line 1: name 'cell'")
