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


def test_a_cause_that_fits_only_some_of_the_calls_is_not_told() -> None:
    program = """
def cell_of(x, y):
    return (int(y / 10), int(x / 10)) if x > 0 else (99, 99)
"""
    mark = marked(CELL, program)
    assert statuses(mark) == ["failed", "failed"]
    assert [each["likely"] for each in mark["checks"]] == [None, None]


def test_a_cause_that_the_programs_text_contradicts_is_not_told() -> None:
    program = """
import math
def cell_of(x, y):
    return towards_0(x / 10), towards_0(y / 10)
def towards_0(value):
    return math.floor(value) if value > 0 else math.ceil(value)
"""
    assert failed(marked(CELL, program))["likely"] is None
    with_int = "def cell_of(x, y):\n    return int(x / 10), int(y / 10)\n"
    assert failed(marked(CELL, with_int))["likely"] == "int() cuts towards 0"


WHERE = """
from grader import calls, check, function, lacks, mistake, number, operator, reads

limit = function("inside(x)", lambda x: 0 <= x < 200, mistakes=[
    mistake("the edge", lambda x: 0 < x < 200, where=CONDITION),
])

@check("Edges")
def edges(task):
    for x in (0, 1, 199, 200):
        task.call(limit, x)
"""


@pytest.mark.parametrize(
    ("condition", "told"),
    [
        ('operator("<")', True),
        ('operator("<=")', False),
        ('lacks(operator("<="))', True),
        ('calls("around")', True),
        ('calls("int")', False),
        ('reads("x")', True),
        ('reads("CELL")', False),
        ("number(200)", True),
        ("number(7)", False),
        ('(operator("<"), number(7))', False),
    ],
)
def test_a_check_can_state_what_must_stand_in_the_program(condition: str, told: bool) -> None:
    program = """
OTHER = 7 <= int(8)
def around(x):
    return x < 200
def inside(x):
    return 0 < x and around(x)
"""
    mark = failed(marked(WHERE.replace("CONDITION", condition), program))
    assert mark["likely"] == ("the edge" if told else None)


CONSTANT = """
from grader import check, function
centre = function("centre(column)", lambda column: (column + 0.5) * 10)
centre_4 = function("centre(column)", lambda column: (column + 0.5) * 4)

@check("Cells of 10 cm")
def ten(task):
    task.call(centre, 2, gives=25.0)

@check("Cells of 4 cm")
def four(task):
    task.set("CELL", 4)
    task.call(centre_4, 2, gives=10.0)
"""


@pytest.mark.parametrize(
    ("start", "body"),
    [
        ("CELL = 10\nHALF = CELL / 2", "column * CELL + HALF"),
        ("CELL, OTHER = 10, 3\nHALF = CELL / 2", "column * CELL + HALF"),
        ("CELL: int = (\n    10\n)\nHALF = CELL / 2", "column * CELL + HALF"),
        ("CELL = 10\nhalf = lambda size=CELL: size / 2", "column * CELL + half()"),
        ("from fractions import Fraction\nCELL = 10", "Fraction(2 * column + 1, 2) * CELL"),
    ],
)
def test_a_constant_is_changed_before_the_program_runs(start: str, body: str) -> None:
    mark = marked(CONSTANT, f"{start}\ndef centre(column):\n    return {body}\n")
    assert mark["passed"], mark


def test_what_was_changed_is_told() -> None:
    program = "CELL = 10\ndef centre(column):\n    return (column + 0.5) * 10\n"
    assert failed(marked(CONSTANT, program))["expected"] == "with CELL = 4, centre(2) gives 10.0"


@pytest.mark.parametrize(
    ("body", "likely"),
    [
        ("print(x // 10, y // 10)", "it prints its answer"),
        ("pass", "a function hands back its answer with return"),
        ("return None if x > 0 else (0, 0)", None),
    ],
)
def test_what_was_returned_is_told_though_the_given_code_breaks_on_it(
    body: str, likely: str | None
) -> None:
    start = f"def cell_of(x, y):\n    {body}\n"
    first = failed(marked(CELL, f"{start}\ncolumn, row = cell_of(32, 74)\nprint(column)\n"))
    assert first["expected"] == "cell_of(32, 74) gives (3, 7)"
    assert first["got"] == "cell_of(32, 74) returned None"
    assert (first["likely"] or "None").startswith(likely or "None")


def test_a_program_that_breaks_though_its_function_is_right_fails_with_its_own_error() -> None:
    first = failed(marked(CELL, f"{RIGHT}\nprint(undefined)\n"))
    assert first["expected"] == "a program that runs without an error"
    assert first["got"].startswith("NameError on line 5")


@pytest.mark.parametrize(
    ("body", "likely"),
    [
        ("return Cell()", "it is a Cell; the task asks for a tuple of 2, such as (3, 7)"),
        ("return {x // 10, y // 10}", "it is a set, which has no order; the task asks for a tuple"),
    ],
)
def test_an_answer_of_another_kind_is_told_as_that(body: str, likely: str) -> None:
    program = f"class Cell:\n    pass\n\ndef cell_of(x, y):\n    {body}\n"
    assert failed(marked(CELL, program))["likely"].startswith(likely)


@pytest.mark.filterwarnings("ignore:coroutine")
def test_an_async_function_is_told_as_that() -> None:
    first = failed(marked(CELL, "async def cell_of(x, y):\n    return 3, 7\n"))
    assert first["likely"].startswith("cell_of is an async function")


SETS = """
from grader import check, function
evens = function("evens(n)", lambda n: {i for i in range(n) if i % 2 == 0})
clear = function("clear(cells)", lambda cells: cells.clear(), changes="cells")

@check("Evens")
def some(task):
    task.call(evens, 5)
    task.call(evens, 8)

@check("Clear")
def none(task):
    task.call(clear, [1, 2])
"""


def test_a_list_for_a_set_and_a_new_value_for_a_changed_one_are_told() -> None:
    program = """
def evens(n):
    return [i for i in range(n) if i % 2 == 0]
def clear(cells):
    return []
"""
    first, second = marked(SETS, program)["checks"]
    assert first["likely"] == "it is a list; the task asks for a set: set(…)"
    assert second["likely"].startswith("it returns a new value and leaves cells as it was")


def test_none_for_an_empty_list_is_told_as_that() -> None:
    check = SETS.replace("{i for i in range(n) if i % 2 == 0}", "list(range(n))")
    program = (
        "def evens(n):\n    return list(range(n)) if n > 5 else None\ndef clear(c): c.clear()\n"
    )
    first = failed(marked(check.replace("5)", "0)"), program))
    assert first["likely"] == "an empty list is asked for, not None: return that"


def test_expected_is_never_the_same_text_as_got() -> None:
    check = """
from grader import check, function
row = function("row()", lambda: [[float(i), i / 3, i] for i in range(12)])

@check("Row")
def complete(task):
    task.call(row)
"""
    values = "[[float(i), i / 3 + (i == 11) * 1e-7, i] for i in range(12)]"
    first = failed(marked(check, f"def row():\n    return {values}\n"))
    assert first["expected"].removeprefix("row() gives ") != first["got"]
    assert "item 11 (counted from 0)" in first["expected"]
    assert "3.6666666666666665" in first["expected"]


def test_a_slip_that_raises_explains_the_same_error() -> None:
    first = failed(marked(CELL, "def cell_of(x, y):\n    return x / 0\n"))
    assert first["got"] == "ZeroDivisionError on line 2: division by zero"
    assert first["likely"] == "no guard"


@pytest.mark.parametrize(
    ("body", "likely"),
    [
        ("x", "a function hands back its answer with return, and this one has no return"),
        ("print(x)", "it prints its answer instead of returning it"),
        ("return x // 10 + 0.0, y // 10 + 0.0", "the numbers are right, but they are floats"),
        (
            "return str((x // 10, y // 10))",
            "it is a text, '(3, 7)'; the task asks for a tuple of 2, such as (3, 7): leave out",
        ),
        (
            "return (each // 10 for each in (x, y))",
            "it is a generator, which is no tuple yet: put tuple() round it",
        ),
        (
            "return map(int, (x / 10, y / 10))",
            "it is a map, which is no tuple yet: put tuple() round it",
        ),
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
            "the numbers are right, but they are floats where whole numbers are wanted: "
            "math.floor() and int() make whole numbers, .astype(int) those of an array",
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
        "after add([0.0, 1.0, 0.0, 0.0], 1, 0.85), cells has "
        "1.85 in the cell in column 1, row 0, around (150, 50)"
    )
    assert first["got"] == "0.85"
    assert first["likely"] == "put, not added"
    assert first["where"]["cells"] == [[1, 0]]


PATHS = """
from grader import check, function, in_words

path = function(
    "path(a, b)",
    lambda a, b: [a, (0, 5), b],
    compare=in_words(
        lambda expected, got: len(expected) == len(got),
        lambda expected, got: (f"a path of {len(expected)} cells", f"{len(got)} cells"),
    ),
    cell_cm=10,
)

@check("A path")
def one(task):
    task.call(path, (0, 0), (2, 0))
"""


def test_of_several_right_answers_none_is_asked_for_and_the_learners_own_is_outlined() -> None:
    assert marked(PATHS, "def path(a, b):\n    return [a, (1, 0), b]\n")["passed"]
    first = failed(marked(PATHS, "def path(a, b):\n    return [a, b]\n"))
    assert first["expected"] == "path((0, 0), (2, 0)) gives a path of 3 cells"
    assert first["got"] == "2 cells"
    assert first["where"]["cells"] == [[0, 0], [2, 0]]


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
    assert (failed(mark)["expected"], failed(mark)["got"]) == (
        "after tick() (twice), count is 2",
        "4",
    )


def test_of_a_long_list_in_a_variable_the_item_that_differs_is_named() -> None:
    check = """
from grader import check, function

add = function("add(cell)", lambda cell: None)

@check("A long list")
def a_long_list(task):
    task.call(add, 3)
    task.variable("cells", gives=[0, 0, 0, 1] + [0] * 96)
"""
    program = "cells = [0] * 100\ndef add(cell):\n    cells[cell] += %d\n"
    assert marked(check, program % 1)["passed"]
    told = failed(marked(check, program % 2))
    assert told["expected"] == "after add(3), cells has 1 as item 3 (counted from 0)"
    assert told["got"] == "2"


def test_what_is_wrong_with_a_grid_in_a_variable_is_told_by_cell_calls_and_cause() -> None:
    check = """
from grader import between, check, function

add = function("add(cell)", lambda cell: None)
some = between(-2, -0.2, "evidence of floor")
LEFT = [("it counts down", lambda: [0, 0, 0, -10], 1)]

@check("A grid")
def a_grid(task):
    for cell in (3, 3):
        task.call(add, cell)
    task.variable("cells", gives=[0, 0, 0, some], mistakes=LEFT, grid_cm=100)
"""
    program = "cells = [0] * 4\ndef add(cell):\n    cells[cell] -= %s\n"
    assert marked(check, program % 0.5)["passed"]
    told = failed(marked(check, program % 5))
    assert told["expected"] == (
        "after add(3) (twice), cells has evidence of floor in the cell in column 1, row 1, "
        "around (150, 150)"
    )
    assert (told["got"], told["likely"], told["hint"]) == ("-10", "it counts down", 1)
    assert told["where"]["cells"] == [[1, 1]]
    assert failed(marked(check, program % 4))["likely"] is None


def test_of_many_calls_before_a_variable_only_the_last_is_named() -> None:
    check = """
from grader import check, function

add = function("add(cell)", lambda cell: None)

@check("Five")
def five(task):
    for cell in range(5):
        task.call(add, cell)
    task.variable("count", gives=5)
"""
    told = failed(marked(check, "count = 0\ndef add(cell):\n    pass\n"))
    assert told["expected"] == "after 5 calls, the last of them add(4), count is 5"


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


LEAVES = """
from grader import check, function
largest = function("largest(sizes)", max, leaves=True)

@check("Any sizes", hint=2)
def any_sizes(task):
    task.call(largest, [3, 1], gives=3)

@check("With TIMES at 2")
def another(task):
    task.set("TIMES", 2)
    task.call(largest, [3, 1], gives=3)
"""


def test_a_right_answer_that_was_had_by_changing_an_argument_is_refused_without_a_hint() -> None:
    mark = marked(
        LEAVES,
        "TIMES = 1\ndef largest(sizes):\n    sizes.sort()\n    return sizes[-1]\n",
    )
    first, second = mark["checks"]
    assert first["expected"] == "after largest([3, 1]), sizes is as it was: [3, 1]"
    assert first["got"] == "[1, 3]"
    assert "work on a copy, list(sizes)" in first["likely"]
    assert first["hint"] is None
    assert second["expected"].startswith("with TIMES = 2, after largest([3, 1]), sizes is")


def test_a_wrong_answer_is_told_before_a_changed_argument() -> None:
    mark = marked(LEAVES, "TIMES = 1\ndef largest(sizes):\n    return sizes.pop()\n")
    assert failed(mark)["expected"] == "largest([3, 1]) gives 3"


def test_an_argument_that_is_copied_may_be_worked_on() -> None:
    program = "TIMES = 1\ndef largest(sizes):\n    sizes = sorted(sizes)\n    return sizes[-1]\n"
    assert marked(LEAVES, program)["passed"]
