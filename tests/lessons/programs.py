"""Running a lesson's program and reading what it left, for the tests in this folder."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

from bugbot import worlds
from bugbot.run import outcome_of, run_program
from bugbot.trace import Trace
from mapping.frontiers import State
from mapping.grid import Grid
from mapping.score import Rectangle, Score, score

LESSONS = Path(__file__).parents[2] / "lessons"
DEMOS = LESSONS / "occupancy-grid-mapping" / "programs"


def with_numbers(source: str, **numbers: object) -> str:
    """The program with some of its numbers at the top changed, as an experiment does it."""
    for name, value in numbers.items():
        source, found = re.subn(rf"^{name} = \S+", f"{name} = {value}", source, flags=re.M)
        if found != 1:
            raise ValueError(f"{name} is set {found} times at the start of a line, not once")
    return source


@cache
def _run(file: Path, world: str, seed: int, numbers: tuple[tuple[str, object], ...]) -> Trace:
    return run_program(with_numbers(file.read_text("utf-8"), **dict(numbers)), world, seed)


def run(file: Path, world: str, seed: int = 1, **numbers: object) -> tuple[Trace, dict[str, Any]]:
    """Trace and outcome of a program's file; the same run is made only once."""
    trace = _run(file, world, seed, tuple(sorted(numbers.items())))
    return trace, outcome_of(trace)


def value_at(outcome: dict[str, Any], line: str, seconds: float) -> float:
    """What a line of the chart shows at a time: its last point up to then."""
    return [value for t, value in outcome["series"][line] if t <= seconds + 1e-9][-1]


def drawn_map(outcome: dict[str, Any]) -> tuple[Grid, list[State]]:
    """The map as the layers `free` and `occupied` show it; a cell in both is an error."""
    layers = outcome["layers"]
    grid = Grid(layers["free"]["size"])
    states = [State.UNKNOWN] * len(grid.cells)
    for layer, state in (("free", State.FREE), ("occupied", State.OCCUPIED)):
        for x, y in layers[layer]["points"]:
            index = grid.index_at(x, y)
            if index is None or states[index] is not State.UNKNOWN:
                raise ValueError(f"{layer} has a square at ({x}, {y}), which is taken or no cell")
            states[index] = state
    return grid, states


def obstacles_of(world: str) -> list[Rectangle]:
    """What really stands in a world."""
    return [(each.x, each.y, each.width, each.height) for each in worlds.load(world).obstacles]


def score_of(outcome: dict[str, Any], world: str) -> Score:
    """The drawn map held against the truth."""
    return score(*drawn_map(outcome), obstacles_of(world))
