"""No program in cheats/ passes, and each is told why in plain words."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from grader.marking import Performer, mark_program
from grader.report import text_of

CHEATS = sorted(Path(__file__).with_name("cheats").glob("*.py"))

CHECKS = {
    "cell": """
from math import floor
from grader import check, function

cell_of = function("cell_of(x, y)", lambda x, y: (floor(x / 10), floor(y / 10)))

@check("A cell")
def cell(task):
    task.call(cell_of, 32, 74, gives=(3, 7))
    task.call(cell_of, 0, 0, gives=(0, 0))
""",
    "numbers": """
from grader import check, function

total = function("total(numbers)", sum)

@check("A sum")
def numbers(task):
    task.call(total, [1, 2, 3])
    task.call(total, [])
""",
    "map": """
from grader import check

@check("A map")
def made(task):
    run = task.run("post-and-shelf", seed=5, seconds=30)
    run.map().wrong_walls(at_most=100)
""",
    "mapped": """
from grader import check

@check("A map of something")
def made(task):
    task.run("post-and-shelf", seed=5, seconds=30).map().known(at_least=0.05)
""",
    "drive": """
from grader import check

@check("A drive")
def made(task):
    task.run("post-and-shelf", seed=5, seconds=30).never_bumps()
""",
    "chance": """
from math import floor
from grader import check, function

cell_of = function("cell_of(x, y)", lambda x, y: (floor(x / 10), floor(y / 10)))

@check("Any points")
def points(task):
    for _ in range(20):
        task.call(cell_of, task.random.randrange(200), task.random.randrange(200))
""",
}
"""Easy to satisfy, so that only honesty is asked for."""

CELL_OF = "def cell_of(x, y):\n    return x // 10, y // 10\n"

HONEST = {
    "cell": CELL_OF,
    "chance": CELL_OF,
    "drive": "from bugbot import *\nforward(50, distance=5)\n",
    "numbers": "def total(numbers):\n    return sum(numbers)\n",
    "map": """
from bugbot import *
scan()
draw("free", [(102.5, 107.5)], "#9ecae1", "squares", 5)
draw("occupied", [], "black", "squares", 5)
""",
}

HONEST["mapped"] = HONEST["map"]

LESSON = {"slug": "honesty", "worlds": {}}


@pytest.fixture(scope="module")
def performer() -> Iterator[Performer]:
    with Performer() as performer:
        yield performer


def test_there_are_enough() -> None:
    assert len(CHEATS) >= 60


@pytest.mark.parametrize("task", CHECKS)
def test_an_honest_program_passes(task: str, performer: Performer) -> None:
    mark = mark_program(CHECKS[task], LESSON, task, HONEST[task], performer.perform)
    assert mark["passed"], text_of(mark)


@pytest.mark.parametrize("path", CHEATS, ids=lambda path: path.stem)
def test_a_cheat_does_not_pass(path: Path, performer: Performer) -> None:
    program = path.read_text("utf-8")
    head = dict(line[2:].split(": ", 1) for line in program.splitlines()[:3])
    mark = mark_program(CHECKS[head["task"]], LESSON, head["task"], program, performer.perform)
    assert not mark["passed"]
    assert mark["ours"] is None
    said = text_of(mark)
    assert any(words in said for words in head["told"].split(" / ")), said
    assert "Traceback" not in said
    # Nothing that a program brings along begins a line of the report.
    assert all(line.startswith("  ") for line in said.splitlines()[1:-1])
