"""U8.7's score: no way of changing the map at the end makes it better than the honest one's."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import dist
from pathlib import Path
from typing import Any

import pytest

from bugbot.run import run_program
from bugbot.worlds import load
from grader.endings import Ending
from grader.maps import Map
from grader.runs import Run
from mapping.frontiers import State
from mapping.grid import Grid

LESSON = Path(__file__).parents[2] / "lessons" / "u8-7-map-the-mat"
SOLUTION = (LESSON / "map-the-mat" / "solution.py").read_text("utf-8")
FREE, OCCUPIED, UNKNOWN = State.FREE, State.OCCUPIED, State.UNKNOWN

GRID = Grid(5)
States = Sequence[State]


def beside(states: States, index: int, state: State) -> int:
    """How many of the cells round one are in a state."""
    return sum(states[each] is state for each in GRID.around(index))


def changed(states: States, change: Callable[[int, State], State]) -> list[State]:
    return [change(index, state) for index, state in enumerate(states)]


CHEATS: dict[str, Callable[[States], list[State]]] = {
    "walls are floor": lambda s: changed(s, lambda _, e: FREE if e is OCCUPIED else e),
    "walls are left out": lambda s: changed(s, lambda _, e: UNKNOWN if e is OCCUPIED else e),
    "every second wall is left out": lambda s: changed(
        s, lambda i, e: UNKNOWN if e is OCCUPIED and i % 2 else e
    ),
    "every second wall is floor": lambda s: changed(
        s, lambda i, e: FREE if e is OCCUPIED and i % 2 else e
    ),
    "black where three neighbours are": lambda s: changed(
        s, lambda i, e: OCCUPIED if e is UNKNOWN and beside(s, i, OCCUPIED) >= 3 else e
    ),
    "black where two neighbours are": lambda s: changed(
        s, lambda i, e: OCCUPIED if e is UNKNOWN and beside(s, i, OCCUPIED) >= 2 else e
    ),
    "free where three neighbours are": lambda s: changed(
        s, lambda i, e: FREE if e is UNKNOWN and beside(s, i, FREE) >= 3 else e
    ),
    "free where a neighbour is": lambda s: changed(
        s, lambda i, e: FREE if e is UNKNOWN and beside(s, i, FREE) else e
    ),
    "all unknown is free": lambda s: changed(s, lambda _, e: FREE if e is UNKNOWN else e),
    "all unknown is black": lambda s: changed(s, lambda _, e: OCCUPIED if e is UNKNOWN else e),
    "a disc of floor": lambda s: changed(
        s, lambda i, e: FREE if dist(GRID.centre(i), (100, 25)) < 40 else e
    ),
    "the left half": lambda s: changed(s, lambda i, e: e if i % 40 < 20 else UNKNOWN),
    "all is black": lambda s: [OCCUPIED] * len(s),
}


def names_of_check() -> dict[str, Any]:
    names: dict[str, Any] = {"__name__": "check"}
    exec((LESSON / "map-the-mat" / "check.py").read_text("utf-8"), names)
    return names


@pytest.fixture(scope="module", params=["flat", "lumber-room", "burrow"])
def honest(request: pytest.FixtureRequest) -> Map:
    """The map that the solution draws on one of the project's mats."""
    world = load(LESSON / "worlds" / f"{request.param}.json")
    trace = run_program(SOLUTION, world, 3)
    job = {"id": "run", "kind": "run", "world": world.to_dict(), "seed": 3, "number": 3}
    run = Run(job, trace, Ending("finished", None))
    return run.map(known=names_of_check()["KNOWN"])


def points(drawn: Map) -> float:
    return float(names_of_check()["POINTS"].points(drawn.run, drawn))


@pytest.mark.parametrize("cheat", CHEATS)
def test_no_change_to_the_map_gains_a_point(honest: Map, cheat: str) -> None:
    states = CHEATS[cheat](honest.states)
    assert states != honest.states
    made = Map(honest.run, honest.grid, states, honest.seconds, 0.62)
    assert points(made) <= points(honest)


def test_an_honest_map_loses_nothing_to_what_is_counted_against_cheats(honest: Map) -> None:
    assert honest.unsupported == []
    assert honest.backed_percent == pytest.approx(honest.known_percent, abs=0.6)
    assert honest.score.wrong_floor_percent < 1
    assert honest.walls_found_percent > 90
