"""Each way in which a submission can be no answer at all gets a truthful mark and a clear message.

The same are told in a page: the interpreter there is ended from outside where a loop never ends.
"""

from __future__ import annotations

import pytest
from judged import CELL, failed, marked, statuses

from performer import calling, perform


@pytest.fixture(autouse=True)
def _impatient(monkeypatch: pytest.MonkeyPatch) -> None:
    # Long enough for what does come to an end, on a machine where others compute as well.
    monkeypatch.setattr(calling, "CALL_S", 0.5)
    monkeypatch.setattr(perform, "PROGRAM_S", 0.5)


RUN = """
from grader import check

@check("A map", hint=0)
def made(task):
    run = task.run("post-and-shelf", seed=5, seconds=20)
    run.map().known(at_least=1)

@check("The same run again", hint=0)
def again(task):
    task.run("post-and-shelf", seed=5, seconds=20).scanned(at_least=1)
"""


@pytest.mark.parametrize(
    ("program", "expected", "got"),
    [
        ("", "a function cell_of(x, y)", "the program has no cell_of"),
        ("PASSED = True\nprint('PASSED')\n", "a function cell_of(x, y)", "has no cell_of"),
        ("def cellOf(x, y):\n    return 1\n", "a function cell_of(x, y)", "has no cell_of"),
        ("cell_of = 3\n", "a function cell_of(x, y)", "cell_of is 3, not a function"),
        (
            "def cell_of(x):\n    return 1\n",
            "a function cell_of(x, y) that can be called with 2 arguments",
            "yours is cell_of(x), which can't be called like that",
        ),
        ("1 / 0\n", "a program that runs without an error", "ZeroDivisionError on line 1"),
        ("def cell_of(x, y)\n", "a program that runs without an error", "SyntaxError on line 1"),
        ("raise ValueError('no')", "a program that runs without an error", "ValueError on line 1"),
        ("while True:\n    pass\n", "a program that comes to its end", "Stopped on line "),
        (
            "while True:\n    print('x' * 1000)\n",
            "a program that comes to its end",
            "Stopped on line 2 after printing 0.2 MB",
        ),
        (
            "def cell_of(x, y):\n    while True:\n        print('x' * 1000)\n",
            "a program that comes to its end",
            "Stopped on line 3 after printing 0.2 MB",
        ),
        (
            "import os\n",
            "a program that keeps to what the marking allows",
            "can't import os",
        ),
        ("#" * 200_001, "a program that keeps to what", "longer than 200,000 characters"),
        ("x = " + "-" * 3000 + "1", "a program that runs", "RecursionError"),
    ],
)
def test_trouble_of_the_whole_program_is_told_once(program: str, expected: str, got: str) -> None:
    mark = marked(CELL, program)
    first = failed(mark)
    assert first["expected"].startswith(expected)
    assert got in first["got"]
    assert first["hint"] is None
    assert statuses(mark) == ["failed", "not run"]


@pytest.mark.parametrize(
    ("body", "got"),
    [
        ("return None", "cell_of(32, 74) returned None"),
        ("while True:\n        pass", "it was still computing on line "),
        ("return cell_of(x, y)", "RecursionError on line "),
        ("raise SystemExit('PASSED')", "SystemExit on line 2: PASSED"),
        ("return [0] * 100000", "a list of more than 50000 parts"),
    ],
)
def test_trouble_of_one_function_is_told_with_the_call(body: str, got: str) -> None:
    first = failed(marked(CELL, f"def cell_of(x, y):\n    {body}\n"))
    assert "cell_of(32, 74)" in first["expected"]
    assert first["got"].startswith(got)


def test_after_two_calls_that_never_came_back_the_others_are_not_begun() -> None:
    check = CELL + "".join(
        f'\n@check("More {n}")\ndef more{n}(task):\n    task.call(cell_of, {n}, 0)\n'
        for n in range(2)
    )
    program = "def cell_of(x, y):\n    while True:\n        pass\n"
    assert statuses(marked(check, program)) == ["failed", "failed", "not run", "not run"]


def test_a_name_that_is_nearly_right_is_pointed_out() -> None:
    first = failed(marked(CELL, "def cellof(x, y):\n    return 1\n"))
    assert first["likely"] == "the program has cellof: perhaps that is the one, under another name"


@pytest.mark.parametrize(
    ("program", "got"),
    [
        ("", "there is no layer"),
        ("1 / 0\n", "ZeroDivisionError on line 1: division by zero"),
        ("while True:\n    wait(1)\n", "NameError on line 2"),
        (
            "from bugbot import *\nwhile True:\n    wait(1)\n",
            "Stopped on line 3 after 20 simulated seconds",
        ),
        ("print('x' * 300000)\n", "Stopped on line 1 after printing 0.2 MB"),
        ("from bugbot import *\nforward('fast')\n", "TypeError on line 2"),
    ],
)
def test_trouble_of_a_run_is_told_with_its_world(program: str, got: str) -> None:
    mark = marked(RUN, program)
    first = failed(mark)
    assert first["got"].startswith(got)
    assert first["where"]["world"]["name"] == "post-and-shelf"
    assert first["where"]["job"].startswith("run-")


def test_the_same_trouble_of_a_run_is_told_once() -> None:
    assert statuses(marked(RUN, "1 / 0\n")) == ["failed", "not run"]
