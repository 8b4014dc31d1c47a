"""Marking a program in this process, for tests: judge and performer are the real ones."""

from __future__ import annotations

from typing import Any

from grader.marking import mark_program
from performer.perform import perform

CELL = """
from math import floor
from grader import check, function

cell_of = function(
    "cell_of(x, y)",
    lambda x, y: (floor(x / 10), floor(y / 10)),
    mistakes=[
        ("row and column look swapped", lambda x, y: (floor(y / 10), floor(x / 10)), 1),
        ("int() cuts towards 0", lambda x, y: (int(x / 10), int(y / 10))),
        ("no guard", lambda x, y: (floor(x / 0), 0)),
    ],
    cell_cm=10,
)

@check("On the mat", hint=0)
def on(task):
    task.call(cell_of, 32, 74, gives=(3, 7))
    task.call(cell_of, 5, 15)

@check("Beside it", hint=2)
def beside(task):
    task.call(cell_of, -5, 15)
"""
"""A check.py of a function task: two checks, three slips."""

RIGHT = "import math\ndef cell_of(x, y):\n    return math.floor(x / 10), math.floor(y / 10)\n"


def marked(
    check: str, program: str, worlds: dict[str, Any] | None = None, shift: int = 0
) -> dict[str, Any]:
    """The mark of a program."""
    lesson = {"slug": "lesson", "worlds": worlds or {}}
    return mark_program(check, lesson, "task", program, perform, shift=shift)


def failed(mark: dict[str, Any]) -> dict[str, Any]:
    """The first failed check of a mark that is nobody's fault but the program's."""
    assert mark["ours"] is None, mark["ours"]
    assert not mark["passed"]
    first: dict[str, Any] = next(each for each in mark["checks"] if each["status"] == "failed")
    return first


def statuses(mark: dict[str, Any]) -> list[str]:
    """What became of each check."""
    return [each["status"] for each in mark["checks"]]
