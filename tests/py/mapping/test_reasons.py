"""The reason that an explorer gives for its end, against small maps of 10 cm cells."""

from __future__ import annotations

import pytest

from mapping.frontiers import State
from mapping.grid import Grid
from mapping.reasons import LARGE, Stop, reason_in, untrue

F, O, U = State.FREE, State.OCCUPIED, State.UNKNOWN  # noqa: E741 - as maps are drawn


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        ("no frontier is left", "none"),
        ("No frontiers left!", "none"),
        ("nothing is left to explore.", "none"),
        ("the map is complete", "none"),
        ("everything is explored", "none"),
        ("only small frontiers are left", "small"),
        ("the frontiers left are too small", "small"),
        ("no frontier can be reached", "shut"),
        ("the rest is unreachable: no way", "shut"),
        ("the rest is too far", "far"),
        ("it has driven far enough", "far"),
        ("max distance", "far"),
        ("time is up", "time"),
        ("out of time", "time"),
        ("lunch", None),
        ("I am tired", None),
        ("42", None),
        ("", None),
        ("sometimes", None),
    ],
)
def test_a_reason_is_told_by_its_words(words: str, reason: str | None) -> None:
    assert reason_in(words) == reason


def rooms(door: bool, unknown_rows: int) -> list[State]:
    """Floor up to a wall in row 10, with a wide door or none; behind it floor, and then unknown."""
    states = [F] * 400
    for column in range(20):
        if not (door and 6 <= column <= 13):
            states[10 * 20 + column] = O
    for index in range((20 - unknown_rows) * 20, 400):
        states[index] = U
    return states


def stop(states: list[State], driven: float = 500.0, seconds: float = 60.0) -> Stop:
    return Stop(Grid(10), states, [(100, 30), (100, 55)], driven, seconds)


def wrong(reason: str, at: Stop) -> str | None:
    found = untrue(reason, at, far_cm=1500, time_s=100)
    return None if found is None else found.found


WHOLE, MORE, SHUT = rooms(True, 0), rooms(True, 4), rooms(False, 4)


def test_that_none_is_left_is_true_without_a_frontier_cell() -> None:
    assert wrong("none", stop(WHOLE)) is None
    assert wrong("none", stop(MORE)) == "there are 20 frontier cells"
    one = WHOLE.copy()
    one[0] = U
    one[1] = O
    assert wrong("none", stop(one)) == "there is 1 frontier cell"
    found = untrue("none", stop(one), far_cm=1500, time_s=100)
    assert found is not None
    assert found.cells == (20,)


def test_small_is_what_is_smaller_than_any_programs_limit() -> None:
    assert LARGE == 20
    assert wrong("small", stop(MORE)) == "there is one of 20 cells"
    narrow = MORE.copy()
    narrow[15 * 20] = O  # nineteen cells are left of the row before the unknown
    assert wrong("small", stop(narrow)) is None
    assert wrong("small", stop(WHOLE)) is None


def test_a_frontier_that_the_robot_was_near_to_may_have_been_given_up() -> None:
    near = Stop(Grid(10), MORE, [(100, 30), (100, 130), (100, 55)], 500, 60)
    assert untrue("small", near, far_cm=1500, time_s=100) is None


def test_out_of_reach_is_what_has_no_wide_way() -> None:
    assert wrong("shut", stop(SHUT)) is None
    assert wrong("shut", stop(MORE)) == "there is a way to one of 20 cells"
    assert wrong("shut", stop(WHOLE)) == "no frontier is left"
    slit = rooms(False, 4)
    slit[10 * 20 + 10] = F  # 10 cm wide: the robot may not fit
    assert wrong("shut", stop(slit)) is None


@pytest.mark.parametrize(
    ("driven", "states", "untrue"),
    [
        (1500, WHOLE, False),
        (1499, WHOLE, True),
        (1300, MORE, False),  # the frontier is 1 m away, and ways may wind
        (1200, MORE, True),
    ],
)
def test_far_enough_counts_the_way_to_the_next_frontier(
    driven: float, states: list[State], untrue: bool
) -> None:
    assert (wrong("far", stop(states, driven=driven)) is not None) is untrue


def test_time_is_up_by_the_clock() -> None:
    assert wrong("time", stop(MORE, seconds=100)) is None
    assert wrong("time", stop(MORE, seconds=99.9)) == "it stopped after 99.9 s"
