"""A learner's function, judged: what is told of each kind of wrong answer."""

from __future__ import annotations

import pytest
from judged import CELL, RIGHT, failed, marked, statuses


def test_a_right_function_passes() -> None:
    mark = marked(CELL, RIGHT)
    assert mark["passed"]
    assert statuses(mark) == ["passed", "passed"]
    assert (mark["format"], mark["lesson"], mark["task"]) == (1, "lesson", "task")


def test_a_slip_that_explains_every_answer_is_named_with_its_hint_and_place() -> None:
    mark = marked(CELL, "def cell_of(x, y):\n    return int(y // 10), int(x // 10)\n")
    first = failed(mark)
    assert first["title"] == "On the mat"
    assert first["expected"] == "cell_of(32, 74) gives (3, 7)"
    assert first["got"] == "(7, 3)"
    assert first["likely"] == "row and column look swapped"
    assert first["hint"] == 1
    assert first["where"]["cells"] == [[3, 7], [7, 3]]
    assert first["where"]["cell_cm"] == 10
    assert first["where"]["world"]["name"] == "empty"


def test_a_slip_seen_only_at_the_edge_is_named_there() -> None:
    mark = marked(CELL, "def cell_of(x, y):\n    return int(x / 10), int(y / 10)\n")
    assert statuses(mark) == ["passed", "failed"]
    assert failed(mark)["likely"] == "int() cuts towards 0"
    assert failed(mark)["hint"] == 2  # the check's own


def test_a_slip_that_explains_one_check_is_named_if_none_explains_all() -> None:
    program = """
def cell_of(x, y):
    return (int(y / 10), int(x / 10)) if x > 0 else (99, 99)
"""
    mark = marked(CELL, program)
    assert statuses(mark) == ["failed", "failed"]
    assert mark["checks"][0]["likely"] == "row and column look swapped"
    assert mark["checks"][1]["likely"] is None


def test_a_slip_that_raises_explains_the_same_error() -> None:
    first = failed(marked(CELL, "def cell_of(x, y):\n    return x / 0\n"))
    assert first["got"] == "ZeroDivisionError on line 2: division by zero"
    assert first["likely"] == "no guard"


@pytest.mark.parametrize(
    ("body", "likely"),
    [
        ("x", "it returns None"),
        ("print(x)", "it prints its answer instead of returning it"),
        ("return x // 10 + 0.0, y // 10 + 0.0", "the numbers are right, but of the wrong kind"),
        ("return str((x // 10, y // 10))", "it gives a text, not a value"),
        ("return (each // 10 for each in (x, y))", "it gives generator, which is not a list yet"),
        ("return map(int, (x / 10, y / 10))", "it gives map, which is not a list yet"),
        ("return 1, 2", "it gives the same answer whatever it is asked"),
    ],
)
def test_usual_slips_need_no_mention_in_a_check(body: str, likely: str) -> None:
    first = failed(marked(CELL, f"def cell_of(x, y):\n    {body}\n"))
    assert first["likely"].startswith(likely)


SAME = """
from grader import check, function

half = function("half(x)", lambda x: x // 2)

@check("Halves")
def halves(task):
    task.call(half, 6, gives=3)
    task.call(half, 7)
"""


def test_two_answers_or_one_right_answer_are_no_sign_of_answering_all_the_same() -> None:
    always = "def half(x):\n    return 1\n"
    assert failed(marked(SAME, always))["likely"] is None
    one_right = SAME.replace("7)", "7)\n    task.call(half, 6.5)").replace("x // 2", "3")
    assert failed(marked(one_right, always))["likely"] is None
    three = SAME.replace("7)", "7)\n    task.call(half, 8)")
    said = failed(marked(three, always))["likely"]
    assert said == "it gives the same answer whatever it is asked"


@pytest.mark.parametrize(
    ("body", "likely"),
    [
        (
            "print(3)",
            "it prints its answer instead of returning it: print() only shows a value, "
            "return hands it to the caller",
        ),
        (
            "return float(x // 2)",
            "the numbers are right, but of the wrong kind: where a whole number is wanted, "
            "2.0 will not do for 2 (// with whole numbers and math.floor() give whole numbers)",
        ),
        ("return x // 2 + 0.9", None),
    ],
)
def test_a_usual_slip_says_what_to_do(body: str, likely: str | None) -> None:
    assert failed(marked(SAME, f"def half(x):\n    {body}\n"))["likely"] == likely


def test_an_error_is_told_with_the_learners_line_and_its_cause() -> None:
    first = failed(marked(CELL, "def cell_of(x, y):\n    return sinus(x / 10), 0\n"))
    assert first["expected"] == "cell_of(32, 74) gives (3, 7)"
    assert first["got"] == "NameError on line 2: name 'sinus' is not defined"
    assert first["likely"].startswith("Nothing is called sinus here")


LIST = """
from grader import check, function, near

add = function(
    "add(cells, index, l)",
    lambda cells, index, l: cells.__setitem__(index, cells[index] + l),
    compare=near(1e-6),
    changes="cells",
    grid_cm=100,
    mistakes=[("put, not added", lambda cells, index, l: cells.__setitem__(index, l))],
)

@check("Two hits")
def twice(task):
    task.call(add, [0.0, 1.0, 0.0, 0.0], 1, 0.85)
"""


def test_a_changed_argument_is_judged_and_its_cells_outlined() -> None:
    right = "def add(cells, index, l):\n    cells[index] += l\n"
    assert marked(LIST, right)["passed"]
    first = failed(marked(LIST, right.replace("+=", "=")))
    assert first["expected"] == (
        "add([0.0, 1.0, 0.0, 0.0], 1, 0.85) leaves in cells "
        "1.85 in the cell in column 1, row 0, round (150, 50)"
    )
    assert first["got"] == "0.85"
    assert first["likely"] == "put, not added"
    assert first["where"]["cells"] == [[1, 0]]


def test_a_grid_in_rows_is_a_grid_and_anything_else_is_compared_whole() -> None:
    check = LIST.replace('    changes="cells",\n', "").replace(
        "lambda cells, index, l: cells.__setitem__(index, cells[index] + l)",
        "lambda cells, index, l: [[0.0, 1.85], [0.0, 0.0]]",
    )
    rows = "def add(cells, index, l):\n    return [[0, 1.85], [0, %s]]\n"
    assert marked(check, rows % 0)["passed"]
    assert failed(marked(check, rows % 3))["where"]["cells"] == [[1, 1]]
    assert failed(marked(check, "def add(c, i, l):\n    return 1, 2, 3\n"))["got"] == "(1, 2, 3)"
    assert failed(marked(check, "def add(c, i, l):\n    return 7\n"))["got"] == "7"


STATE = """
from grader import check, function

tick = function("tick()", lambda: None, compare=lambda expected, got: got is None)

@check("It counts")
def counts(task):
    task.call(tick)
    task.call(tick)
    task.variable("count", gives=2)

@check("From where it is set")
def set_first(task):
    task.set("count", 5)
    task.call(tick)
    task.variable("count", gives=6)
    task.variable("name")
"""
COUNTER = "count = 0\nname = 'n'\ndef tick():\n    global count\n    count = count + %d\n"


def test_each_check_begins_anew_and_its_calls_happen_in_order() -> None:
    assert marked(STATE, COUNTER % 1)["passed"]
    mark = marked(STATE, COUNTER % 2)
    assert statuses(mark) == ["failed", "failed"]
    assert (failed(mark)["expected"], failed(mark)["got"]) == ("count is 2", "4")


def test_a_variable_that_is_not_there_is_asked_for() -> None:
    first = failed(marked(STATE, "counts = 0\ndef tick():\n    pass\n"))
    assert (first["expected"], first["got"]) == ("a variable count in the program", "there is none")
    assert "the program has counts" in first["likely"]


def test_a_function_may_use_the_robot_where_the_check_puts_it() -> None:
    check = """
from grader import check, function, near

ahead = function("ahead()", lambda: 110.0, compare=near(10))

@check("A wall")
def wall(task):
    task.call(ahead, world="wall-ahead", seed=3)
"""
    program = "from bugbot import *\ndef ahead():\n    return %s\n"
    assert marked(check, program % "distance()")["passed"]
    assert failed(marked(check, program % "position()"))["got"] == "(0.0, 0.0)"


def test_chance_differs_from_shift_to_shift_only() -> None:
    check = """
from grader import check, function

f = function("f(x)", lambda x: x)

@check("Any number")
def any_number(task):
    task.call(f, task.random.random())
"""
    program = "def f(x):\n    return 0\n"
    first = failed(marked(check, program))["expected"]
    assert failed(marked(check, program))["expected"] == first
    assert failed(marked(check, program, shift=1000))["expected"] != first
