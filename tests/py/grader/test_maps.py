"""Maps that a run has drawn: what is said of one that is not as it should be, and where."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

import pytest
from judged import failed, marked

from grader.failures import CheckFailed
from grader.maps import Map
from mapping.evidence import Evidence
from mapping.frontiers import State
from mapping.grid import Grid

if TYPE_CHECKING:
    from grader.runs import Run
    from mapping.evidence import Beam

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
    """A run on a bare mat, with the beams that it has seen by."""

    obstacles = ()

    def __init__(self, *beams: Beam, met: dict[int, int] | None = None) -> None:
        self.beams = beams
        self.met = met or {}

    def evidence(self, grid: Grid, _seconds: float) -> Evidence:
        return Evidence(grid, self.beams)

    def surfaces(self, _grid: Grid, _seconds: float) -> dict[int, int]:
        return self.met

    def failure(self, expected: str, got: str, **where: Any) -> CheckFailed:
        likely = where.pop("likely", None)
        return CheckFailed(expected, got, likely=likely, where=where)


def rows_crossed(rows: int) -> Seen:
    """A run that has seen the floor of so many rows of 10 cm, up to 170 cm from the left."""
    return Seen(*((0.0, 10 * row + 5.0, 90.0, 200.0) for row in range(rows)))


@pytest.mark.parametrize(
    ("known", "unseen", "refused"),
    [(10, 3, False), (10, 4, True), (200, 4, False), (200, 5, True), (199, 4, True)],
)
def test_a_few_cells_may_be_unseen_three_or_one_in_fifty(
    known: int, unseen: int, refused: bool
) -> None:
    crossed = [row * 20 + column for row in range(12) for column in range(17)]
    beyond = [15 * 20 + column for column in range(unseen)]
    states = [U] * 400
    for index in crossed[: known - unseen] + beyond:
        states[index] = F
    drawn = small(*states, run=rows_crossed(12), cell_cm=10)
    if not refused:
        drawn.must_have_been_seen()
        return
    with pytest.raises(CheckFailed) as caught:
        drawn.must_have_been_seen()
    failure = caught.value
    assert failure.got.startswith(f"{unseen} of its {known} known cells lie where no beam has been")
    where = failure.where or {}
    assert (where["cell_cm"], where["seconds"], len(where["cells"])) == (10, 3.0, unseen)


def test_a_map_may_be_as_far_off_as_its_poses() -> None:
    states = [U] * 400
    for column in range(10):
        states[3 * 20 + column] = F  # the floor that was seen is that of rows 0 and 1
    right = Map(cast("Run", rows_crossed(2)), Grid(10), states, 3.0)
    with pytest.raises(CheckFailed):
        right.must_have_been_seen()
    Map(cast("Run", rows_crossed(2)), Grid(10), states, 3.0, off_by=10).must_have_been_seen()


# -- what is drawn without support -----------------------------------------------------

UP = (105.0, 105.0, 0.0, 58.0)
"""From the cell in column 10, row 10, of 10 cm, to the one in row 16."""


def column_ten(**rows: State) -> list[State]:
    """A map of 20 by 20 cells that knows some rows of column 10, named r10 and so on."""
    states = [U] * 400
    for row, state in rows.items():
        states[int(row[1:]) * 20 + 10] = state
    return states


def of_ups(beams: int, known: float = 1.0, **rows: State) -> Map:
    run = cast("Run", Seen(*[UP] * beams))
    return Map(run, Grid(10), column_ten(**rows), 3.0, known)


def test_known_cells_count_only_if_the_beams_support_them() -> None:
    # After one beam: floor has -0.8, which is not beyond 1; after two it is.
    assert of_ups(1, r12=F).known_percent == 0
    assert of_ups(2, r12=F).known_percent == 100 / 400
    assert of_ups(1, known=0.62, r12=F).known_percent == 100 / 400
    # One hit is 0.85.
    assert of_ups(1, r16=O).unsupported == [16 * 20 + 10]
    assert of_ups(2, r16=O).unsupported == []
    # A wall that is called floor, and floor that is called a wall.
    assert of_ups(9, r12=O, r16=F).unsupported_percent == 200 / 400
    assert of_ups(9, r12=O, r16=F).known_percent == 0


def test_cells_painted_beside_what_was_seen_are_told() -> None:
    painted = of_ups(5, r12=F, r16=O, r17=O)
    assert painted.unsupported_cells(at_most=34) is painted
    with pytest.raises(CheckFailed) as caught:
        painted.unsupported_cells(at_most=33)
    assert caught.value.got == "33.3 %: 1 of 3 cells"
    assert (caught.value.where or {})["cells"] == [(10, 17)]
    with pytest.raises(CheckFailed, match="not counting 3 cells"):
        of_ups(5, r12=F, r16=O, r17=O, r18=O, r19=O).known(at_least=1)


def test_floor_is_backed_if_every_rule_finds_it_free() -> None:
    # Less than a cell before the hit, only the rule that goes up to the hit calls it free.
    close = of_ups(5, r15=F)
    assert (close.known_percent, close.backed_percent) == (100 / 400, 0)
    far = of_ups(5, r12=F, r16=O)
    assert far.backed_percent == 200 / 400


def test_what_is_plain_has_to_be_drawn() -> None:
    whole = of_ups(6, r10=F, r11=F, r12=F, r13=F, r14=F, r16=O)
    assert whole.plain(floor_at_least=100, walls_at_least=100) is whole
    with pytest.raises(CheckFailed) as caught:
        of_ups(6, r10=F, r11=F, r13=F, r14=F, r16=O).plain(90, 100)
    assert caught.value.got == "80.0 %: 1 of 5 is not"
    assert (caught.value.where or {})["cells"] == [(10, 12)]
    with pytest.raises(CheckFailed, match="plainly wall"):
        of_ups(6, r10=F, r11=F, r12=F, r13=F, r14=F, r16=F).plain(100, 1)


@pytest.mark.parametrize(
    ("met", "percent"),
    [
        ({330: 3}, 100),  # the black cell itself, row 16
        ({329: 3, 350: 4}, 100),  # beside it
        ({330: 9, 370: 3}, 50),  # two rows on
        ({330: 9, 370: 2}, 100),  # where too few beams have been
        ({}, 100),
    ],
)
def test_walls_are_found_if_they_are_black_within_a_cell(
    met: dict[int, int], percent: float
) -> None:
    run = cast("Run", Seen(met=met))
    drawn = Map(run, Grid(10), column_ten(r16=O), 3.0)
    assert drawn.walls_found_percent == percent
    if percent < 100:
        with pytest.raises(CheckFailed) as caught:
            drawn.walls_found(at_least=51)
        assert caught.value.got == "50.0 %: 1 of 2 places"
        assert (caught.value.where or {})["cells"] == [(10, 18)]
    assert drawn.walls_found(at_least=50) is drawn


def test_one_cell_is_told_in_the_singular() -> None:
    run = Seen()
    with pytest.raises(CheckFailed) as caught:
        small(F, F, O, U, run=run).agrees(small(F, F, O, F, run=run), at_least=99)
    assert caught.value.got == "75.0 %: 1 cell differs"


def test_where_two_maps_differ_is_told() -> None:
    run = Seen()
    with pytest.raises(CheckFailed) as caught:
        small(F, F, O, U, run=run).agrees(small(F, O, O, F, run=run), at_least=51)
    failure = caught.value
    assert failure.got == "50.0 %: 2 cells differ"
    assert failure.where == {"cells": [(1, 0), (1, 1)], "cell_cm": 100, "seconds": 3.0}
    assert small(F, F, O, U, run=run).agrees(small(F, O, O, F, run=run), at_least=50)


def test_how_much_is_known_is_counted_in_cells() -> None:
    half = small(F, O, U, U, run=Seen((50, 50, 90, 100)))
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
        (squares("fre", "[]"), 'perhaps your layer "fre" is meant: call it "free"'),
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
    assert first["got"] == 'the layers are "goal" and "way"'
    nothing = judged("")
    assert nothing is not None
    assert nothing["got"] == "there is no layer"


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
