"""Maps that a run has drawn: what is said of one that is not as it should be, and where."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

import pytest
from judged import failed, marked

from grader.failures import CheckFailed
from grader.maps import Map
from mapping.frontiers import State
from mapping.grid import Grid

if TYPE_CHECKING:
    from grader.runs import Run

F, O, U = State.FREE, State.OCCUPIED, State.UNKNOWN  # noqa: E741 - as maps are drawn

# -- four cells of a metre -----------------------------------------------------------


def small(*states: State, run: object = None, cell_cm: float = 100) -> Map:
    return Map(cast("Run", run), Grid(cell_cm), states, 3.0)


@pytest.mark.parametrize(
    ("one", "other", "percent"),
    [
        ((F, F, O, U), (F, F, O, U), 100),
        ((F, F, O, U), (F, O, O, U), 100 * 2 / 3),
        ((F, U, U, U), (U, O, U, U), 0),
        ((O, U, U, U), (O, U, U, U), 100),
        ((U, U, U, U), (U, U, U, U), 0),
    ],
)
def test_agreement_is_counted_over_what_either_knows(
    one: tuple[State, ...], other: tuple[State, ...], percent: float
) -> None:
    assert small(*one).agreement(small(*other)) == pytest.approx(percent)


def test_maps_of_other_cells_do_not_agree_at_all() -> None:
    assert small(F, F, F, F).agreement(small(*[F] * 16, cell_cm=50)) == 0


class Seen:
    """A run whose beams have been at the first so many cells of a bare mat."""

    obstacles = ()

    def __init__(self, cells: int) -> None:
        self.cells = cells

    def touched(self, _grid: Grid, _seconds: float) -> set[int]:
        return set(range(self.cells))

    def failure(self, expected: str, got: str, **where: Any) -> CheckFailed:
        likely = where.pop("likely", None)
        return CheckFailed(expected, got, likely=likely, where=where)


@pytest.mark.parametrize(
    ("known", "unseen", "refused"),
    [(10, 3, False), (10, 4, True), (200, 4, False), (200, 5, True), (199, 4, True)],
)
def test_a_few_cells_may_be_unseen_three_or_one_in_fifty(
    known: int, unseen: int, refused: bool
) -> None:
    states = [F] * known + [U] * (400 - known)
    drawn = small(*states, run=Seen(known - unseen), cell_cm=10)
    if not refused:
        drawn.must_have_been_seen()
        return
    with pytest.raises(CheckFailed) as caught:
        drawn.must_have_been_seen()
    failure = caught.value
    assert failure.got == f"{unseen} of its {known} known cells lie where no beam has been"
    where = failure.where or {}
    assert (where["cell_cm"], where["seconds"], len(where["cells"])) == (10, 3.0, unseen)


def test_where_two_maps_differ_is_told() -> None:
    run = Seen(0)
    with pytest.raises(CheckFailed) as caught:
        small(F, F, O, U, run=run).agrees(small(F, O, O, F, run=run), at_least=51)
    failure = caught.value
    assert failure.got == "50.0 %: 2 cells differ"
    assert failure.where == {"cells": [(1, 0), (1, 1)], "cell_cm": 100, "seconds": 3.0}
    assert small(F, F, O, U, run=run).agrees(small(F, O, O, F, run=run), at_least=50)


def test_how_much_is_known_is_counted_in_cells() -> None:
    half = small(F, O, U, U, run=Seen(0))
    assert half.known(at_least=50, at_most=50) is half
    with pytest.raises(CheckFailed) as caught:
        half.known(at_least=50.1)
    assert (caught.value.expected, caught.value.got) == (
        "at least 50.1 % of the mat known",
        "50.0 %",
    )
    assert caught.value.where == {"cells": [(0, 1), (1, 1)], "cell_cm": 100, "seconds": 3.0}
    with pytest.raises(CheckFailed, match="the rest can't be seen from there"):
        half.known(at_most=49.9)


# -- drawn by a program --------------------------------------------------------------

CHECK = """
from grader import check

@check("It")
def it(task):
    run = task.run("wall-ahead", seed=5, seconds=20)
    """


def judged(program: str, expectation: str = "run.map()") -> dict[str, Any] | None:
    """The failed check, or None if it passes."""
    mark = marked(CHECK + expectation + "\n", f"from bugbot import *\nscan()\nwait(1)\n{program}")
    return None if mark["passed"] else failed(mark)


def squares(name: str, points: str, side: float = 5) -> str:
    return f'draw("{name}", {points}, "blue", "squares", {side})\n'


NO_WALL = squares("occupied", "[]")


@pytest.mark.parametrize(
    ("program", "likely"),
    [
        (
            'draw("free", [(102.5, 62.5)], "blue", "dots", 5)\n',
            'the shape is missing: draw("free", points, colour, "squares", CELL)',
        ),
        (squares("fre", "[]"), 'the layer "fre" is the one that is meant'),
        (squares("goal", "[]"), None),
        (
            squares("free", "[(100, 60)]") + NO_WALL,
            "a square is drawn round its point: the middle is half a cell from the corner",
        ),
        (squares("free", "[(-2.5, 62.5)]") + NO_WALL, None),
    ],
)
def test_the_likely_cause_of_a_map_that_is_none(program: str, likely: str | None) -> None:
    first = judged(program)
    assert first is not None
    assert first["likely"] == likely


def test_the_layers_that_were_drawn_are_listed() -> None:
    first = judged(squares("goal", "[]") + squares("way", "[]"))
    assert first is not None
    assert first["got"] == 'the layers drawn are: "goal", "way"'
    nothing = judged("")
    assert nothing is not None
    assert nothing["got"] == "the layers drawn are: none"


def test_where_a_square_is_no_cell_is_told() -> None:
    first = judged(squares("free", "[(100, 60)]") + NO_WALL)
    assert first is not None
    assert first["where"]["seconds"] == pytest.approx(1.1, abs=0.2)


def test_cells_drawn_as_both_are_shown() -> None:
    twice = squares("free", "[(105, 65)]", 10) + squares("occupied", "[(105, 65)]", 10)
    first = judged(twice)
    assert first is not None
    where = first["where"]
    assert (where["cells"], where["cell_cm"]) == ([[10, 6]], 10)
    assert where["seconds"] == pytest.approx(1.1, abs=0.2)


@pytest.mark.parametrize(
    "points", ["[(103.75, 62.5)]", "[(102.5, 61.25)]"], ids=["to the right", "down"]
)
def test_a_square_may_be_a_quarter_off(points: str) -> None:
    assert judged(squares("free", points) + NO_WALL) is None


def test_cells_may_hang_over_the_far_edges() -> None:
    # Four cells of 60 cm: the last begins at 180 and has its middle at 210.
    over = squares("free", "[(90, 90)]", 60) + squares("occupied", "[(90, 210), (210, 90)]", 60)
    assert judged(over, 'run.map().cell(199, 90, "occupied").cell(90, 199, "occupied")') is None
