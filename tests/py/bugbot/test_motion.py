from math import hypot, sqrt

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from bugbot.sim.motion import first_touch, speeds

BOX = (120.0, 120.0, 140.0, 130.0)  # left, bottom, right, top
RADIUS = 5.0


@pytest.mark.parametrize(
    ("command", "result"),
    [
        ((100, 0, 0), (11.5, 0, 0)),
        ((0, -100, 0), (0, -11.5, 0)),
        ((0, 0, 100), (0, 0, 120)),
        ((50, 25, -10), (5.75, 2.875, -12)),
        ((1e9, -1e9, 101), (11.5, -11.5, 120)),
        ((100, 100, 0), (11.5, 11.5, 0)),  # the axes are independent
    ],
)
def test_per_cents_become_speeds_and_are_clamped(
    command: tuple[float, float, float], result: tuple[float, float, float]
) -> None:
    assert speeds(*command) == pytest.approx(result)


@pytest.mark.parametrize(
    ("x", "y", "dx", "dy", "share", "point"),
    [
        (100, 125, 30, 0, 15 / 30, (120, 125)),  # the left side
        (160, 125, -30, 0, 15 / 30, (140, 125)),  # the right side
        (130, 100, 0, 30, 15 / 30, (130, 120)),  # from below
        (130, 150, 0, -20, 15 / 20, (130, 130)),  # from above
        (100, 100, 200, 250, None, None),  # see below
        (110, 110, 10, 10, (10 * sqrt(2) - 5) / (10 * sqrt(2)), (120, 120)),  # a corner
        (150, 140, -10, -10, (10 * sqrt(2) - 5) / (10 * sqrt(2)), (140, 130)),
        (110, 140, 10, -10, (10 * sqrt(2) - 5) / (10 * sqrt(2)), (120, 130)),
        (150, 110, -10, 10, (10 * sqrt(2) - 5) / (10 * sqrt(2)), (140, 120)),
        (117, 100, 0, 30, 16 / 30, (120, 120)),  # off centre: 3, 4, 5
        (100, 100, 0, 120, 95 / 120, (100, 200)),  # the mat's edge
        (100, 100, 0, -100, 0.95, (100, 0)),
        (100, 50, -100, 0, 0.95, (0, 50)),
        (100, 50, 100, 0, 0.95, (200, 50)),
        (50, 60, -90, -110, 0.5, (0, 5)),  # both edges at once: the first in x
    ],
)
def test_where_a_straight_step_first_touches(
    x: float,
    y: float,
    dx: float,
    dy: float,
    share: float | None,
    point: tuple[float, float] | None,
) -> None:
    touch = first_touch([BOX], x, y, dx, dy)
    if share is None:
        assert touch is not None  # passes over the box's upper left and meets the mat's edge
        return
    assert touch is not None
    assert touch[0] == pytest.approx(share)
    assert touch[1:] == pytest.approx(point)


@pytest.mark.parametrize(
    ("x", "y", "dx", "dy"),
    [
        (100, 100, 0, 0),  # standing
        (100, 125, 14.9, 0),  # too short
        (100, 125, -30, 0),  # away
        (114.9, 100, 0, 60),  # past on the left
        (145.1, 100, 0, 60),
        (100, 135.1, 60, 0),  # past above
        (100, 114.9, 60, 0),  # past below
        (115.5, 100, 0, 17),  # into the square about the corner, but not up to it
        (110, 118, 8, -10),  # round the corner, outside its circle
        (148, 134.5, -2, 6),  # past the corner
        (116, 116, -1, -2),  # from inside the square about the corner, away
    ],
)
def test_steps_that_touch_nothing(x: float, y: float, dx: float, dy: float) -> None:
    assert first_touch([BOX], x, y, dx, dy) is None


@pytest.mark.parametrize(
    ("x", "y", "dx", "dy", "blocked"),
    [
        (130, 115, 0, 1, True),  # into the side it touches
        (130, 115, 0.1, 0.001, True),  # nearly along, but into it
        (130, 115, 1, 0, False),  # along it
        (130, 115, 1, 1e-10, False),  # along it, but for rounding
        (130, 115, 1, -0.001, False),  # away from it
        (117, 116, 1, 1, True),  # into the corner it touches
        (117, 116, 4, -3, False),  # round it
        (117, 116, -4, 3, False),
        (117, 116, 3.9, -3, False),
        (117, 116, 4, -2.9, True),
        (5, 100, -1, 0, True),  # the mat's edge
        (5, 100, 0, 1, False),
        (5, 100, 1, 0, False),
        (195, 195, 1, -1, True),  # in a corner of the mat
        (195, 195, -1, 1, True),
        (195, 195, -1, -1, False),
    ],
)
def test_a_robot_that_touches_may_only_move_along_or_away(
    x: float, y: float, dx: float, dy: float, blocked: bool
) -> None:
    touch = first_touch([BOX], x, y, dx, dy)
    assert (touch is not None) == blocked
    if touch is not None:
        assert touch[0] == pytest.approx(0, abs=1e-9)


def test_the_nearer_of_two_boxes_stops_it() -> None:
    touch = first_touch([(150, 90, 160, 110), (130, 90, 140, 110)], 100, 100, 60, 0)
    assert touch == pytest.approx((25 / 60, 130, 100))


def test_a_box_met_while_gliding_along_another_stops_it() -> None:
    touch = first_touch([(100, 105, 200, 110), (140, 90, 150, 105)], 110, 100, 60, 0)
    assert touch == pytest.approx((25 / 60, 140, 100))


def gap(x: float, y: float) -> float:
    left, low, right, high = BOX
    return hypot(max(left - x, 0, x - right), max(low - y, 0, y - high))


places = st.floats(RADIUS, 200 - RADIUS)
steps = st.floats(-60, 60)


@given(places, places, steps, steps)
def test_no_step_ends_in_or_passes_through_anything(
    x: float, y: float, dx: float, dy: float
) -> None:
    assume(gap(x, y) >= RADIUS)
    touch = first_touch([BOX], x, y, dx, dy)
    share = 1.0 if touch is None else touch[0]
    assert 0 <= share <= 1
    for part in range(11):
        at = (x + share * dx * part / 10, y + share * dy * part / 10)
        assert gap(*at) >= RADIUS - 1e-6
        assert min(at) >= RADIUS - 1e-6
        assert max(at) <= 200 - RADIUS + 1e-6


@given(places, places, steps, steps)
def test_a_step_is_cut_short_only_by_something_that_is_there(
    x: float, y: float, dx: float, dy: float
) -> None:
    assume(gap(x, y) >= RADIUS)
    touch = first_touch([BOX], x, y, dx, dy)
    if touch is None:
        return
    share, px, py = touch
    at = (x + share * dx, y + share * dy)
    assert hypot(px - at[0], py - at[1]) == pytest.approx(RADIUS, abs=1e-6)
    on_edge = min(px, py, 200 - px, 200 - py) == pytest.approx(0, abs=1e-6)
    assert on_edge or gap(px, py) == pytest.approx(0, abs=1e-6)
