"""The scan matcher, on fields small enough to see the answer, and on a square room."""

from collections.abc import Callable
from itertools import pairwise
from math import hypot
from random import Random

import pytest

from bugbot.errors import WrongValueError
from bugbot.frames import direction
from mapping.beam import end_of_beam
from mapping.grid import Grid
from mapping.mapper import Mapper
from mapping.matching import Follower, Match, Pose, Window, hits_of, likelihoods, match, place

FAN = [-19.6875 + 5.625 * i for i in range(8)]


def field(*cells: tuple[int, int], cell_cm: float = 5.0) -> Grid:
    """A field that is 1 in these (column, row) cells."""
    grid = Grid(cell_cm)
    for cell in cells:
        grid.cells[grid.index(cell)] = 1.0
    return grid


def room(pose: Pose, angle: float) -> float:
    """How far a beam goes in the empty mat [cm]."""
    dx, dy = direction(pose[2] + angle)
    ways = [(200 - pose[0]) / dx if dx > 0 else pose[0] / -dx] if abs(dx) > 1e-9 else []
    ways += [(200 - pose[1]) / dy if dy > 0 else pose[1] / -dy] if abs(dy) > 1e-9 else []
    return min(ways)


def test_a_hit_is_where_its_beam_ends_whatever_the_pose() -> None:
    pose = (70.0, 90.0, 123.0)
    (hit,) = hits_of([(12.0, 45.0)])
    assert place(pose, hit) == pytest.approx(end_of_beam(70, 90, 135, 45))


def test_a_reading_of_nothing_is_no_hit() -> None:
    assert hits_of([(0, 169.9), (0, 170), (5, 200)]) == [pytest.approx((169.9, 0))]


def test_likelihoods_count_walls_fully_from_3_on_and_floor_not_at_all() -> None:
    grid = Grid(5)
    for cell, evidence in {(0, 0): 1.5, (10, 10): 8.0, (20, 20): -8.0}.items():
        grid.cells[grid.index(cell)] = evidence
    found = likelihoods(grid)
    assert found.cells[grid.index((0, 0))] == 0.5
    assert found.cells[grid.index((10, 10))] == 1.0
    assert [found.cells[each] for each in grid.beside(grid.index((10, 10)))] == [0.5] * 4
    assert found.cells[grid.index((11, 11))] == 0.0
    assert found.cells[grid.index((20, 20))] == 0.0
    assert sum(each > 0 for each in found.cells) == 3 + 5


@pytest.mark.parametrize(("column", "turn"), [(21, 2.0), (19, -2.0)])
def test_the_heading_turns_to_where_the_walls_are(column: int, turn: float) -> None:
    # Two hits straight ahead in column 20. 2 degrees move them by 2.8 and 3.1 cm, into the next
    # column; 1 degree is not enough, and 3 cost more.
    found = match(
        field((column, 36), (column, 38)),
        (102.5, 102.5, 0),
        [(80, 0), (90, 0)],
        Window(turn_step_deg=1, shift_cm=0),
    )
    assert found.pose == (102.5, 102.5, turn % 360)
    assert found.fit == 1


def test_the_place_shifts_to_where_the_walls_are() -> None:
    found = match(
        field((20, 30), (30, 20)),
        (99.0, 104.0, 0),
        [(50, 0), (0, 50)],
        Window(turn_deg=0, shift_cm=4, shift_step_cm=2),
    )
    assert found == Match((101.0, 104.0, 0), 1)  # 2 cm are enough for both cells, 4 cost more


@pytest.mark.parametrize("hits", [[], [(30, 0)], [(500, 0)]])
def test_where_nothing_agrees_the_guess_is_kept(hits: list[tuple[float, float]]) -> None:
    assert match(field((1, 1)), (100, 100, 350), hits) == Match((100, 100, 350), 0)


def test_of_equally_good_poses_the_nearest_to_the_guess_is_taken() -> None:
    everywhere = Grid(5)
    everywhere.cells = [1.0] * len(everywhere.cells)
    free = Window(turn_cost=0, shift_cost=0)
    assert match(everywhere, (100, 100, 10), [(50, 0)], free) == Match((100, 100, 10), 1)


def test_leaving_the_guess_must_be_worth_it() -> None:
    grid = field((20, 36))
    grid.cells[grid.index((19, 36))] = 0.97
    hit, guess = [(80.0, 0.0)], (102.5 - 3, 102.5, 0.0)  # it falls into the poorer cell
    near = Window(turn_deg=0, shift_cm=3, shift_step_cm=3, shift_cost=0.1)
    assert match(grid, guess, hit, near).pose == guess
    free = Window(turn_deg=0, shift_cm=3, shift_step_cm=3, shift_cost=0)
    assert match(grid, guess, hit, free).pose == (102.5, 102.5, 0)


@pytest.mark.parametrize("steps", [(0, 1), (1, 0), (-1, 1), (float("nan"), 1)])
def test_a_window_without_steps_is_refused(steps: tuple[float, float]) -> None:
    with pytest.raises(WrongValueError, match="Window wants steps above 0"):
        Window(turn_step_deg=steps[0], shift_step_cm=steps[1])


# -- the front end ---------------------------------------------------------------


def turning(follower: Follower, drift: float, seconds: float = 40) -> float:
    """A robot that turns on one spot of the empty mat; how far off its heading is at the end."""
    chance = Random(5)
    for tick in range(round(seconds * 5)):
        t = tick / 5
        true = (70.0, 90.0, (36 * t) % 360)
        beams = [(angle, room(true, angle) + chance.normalvariate(0, 2)) for angle in FAN]
        follower.add(t, (0, 0, (true[2] + drift * t) % 360), beams)
    return abs((follower.poses[-1][2] - true[2] + 180) % 360 - 180)


def test_it_stops_the_drift_that_odometry_lets_grow() -> None:
    alone = turning(Follower((70, 90, 0), gain=0), 0.25)
    assert alone == pytest.approx(0.25 * 39.8, abs=0.01)
    assert turning(Follower((70, 90, 0)), 0.25) < 0.4 * alone


def test_single_looks_matched_with_the_map_of_just_now_lose_even_a_perfect_odometry() -> None:
    """Eight beams say too little, and the map shares their error: why looks are gathered."""
    assert turning(Follower((70, 90, 0), lag_s=0, every=1, gain=1), 0.0) > 5


def test_without_drift_it_does_no_harm() -> None:
    assert turning(Follower((70, 90, 0)), 0.0) < 2


def test_odometry_is_added_up_along_the_corrected_heading() -> None:
    follower = Follower((50, 60, 90), gain=0)
    assert follower.add(0, (0, 0, 90), []) == (50, 60, 90)
    assert follower.add(1, (10, 0, 90), []) == pytest.approx((60, 60, 90))
    assert follower.add(2, (10, -5, 180), []) == pytest.approx((60, 55, 180))


def test_its_map_holds_each_look_from_its_corrected_pose() -> None:
    follower = Follower((70, 90, 0))
    turning(follower, 0.25, seconds=15)
    wanted = Mapper()
    chance = Random(5)
    for tick, pose in enumerate(follower.poses):
        true = (70.0, 90.0, (36 * tick / 5) % 360)
        wanted.add_scan(*pose, [(a, room(true, a) + chance.normalvariate(0, 2)) for a in FAN])
    assert follower.map().grid.cells == wanted.grid.cells


def test_the_poses_of_one_match_move_together() -> None:
    """Their places stay as far apart as odometry had them."""
    follower = Follower((70, 90, 0))
    turning(follower, 0.25, seconds=30)
    apart = [hypot(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(follower.poses)]
    inside = [each for index, each in enumerate(apart) if index % 5 != 4]
    assert max(inside) < 1e-9


@pytest.mark.parametrize(
    "make",
    [
        lambda: Follower((0, 0, 0), every=0),
        lambda: Follower((0, 0, 0), gain=1.5),
        lambda: Follower((0, 0, 0), lag_s=-1),
    ],
)
def test_a_follower_of_nonsense_is_refused(make: Callable[[], Follower]) -> None:
    with pytest.raises(WrongValueError, match="Follower wants"):
        make()
