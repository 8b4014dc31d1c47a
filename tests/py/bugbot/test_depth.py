from math import cos, radians, sin, sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bugbot.sim.depth import (
    AHEAD,
    ANGLES_DEG,
    BEAMS,
    RANGE_CM,
    distances,
    exact_direction,
    read,
)
from bugbot.sim.noise import DEPTH_SD_CM, generator

BOX = (120.0, 120.0, 140.0, 130.0)  # left, bottom, right, top


def ahead(x: float, y: float, heading: float, *boxes: tuple[float, ...]) -> float:
    return distances(boxes, x, y, heading, AHEAD)[0]  # type: ignore[arg-type]


def test_the_beams_are_the_sensors() -> None:
    assert ANGLES_DEG == (
        -19.6875,
        -14.0625,
        -8.4375,
        -2.8125,
        2.8125,
        8.4375,
        14.0625,
        19.6875,
    )
    assert [angle for angle, _, _ in BEAMS] == list(ANGLES_DEG)


@pytest.mark.parametrize(
    ("heading", "cm"), [(0, 160), (90, 170), (180, 40), (270, 30), (45, 160 * sqrt(2))]
)
def test_a_ray_on_the_empty_mat_ends_at_its_edge(heading: float, cm: float) -> None:
    assert ahead(30, 40, heading) == pytest.approx(cm)


@pytest.mark.parametrize(
    ("x", "y", "heading", "cm"),
    [
        (130, 100, 0, 20),  # from below
        (130, 160, 180, 30),  # from above
        (100, 125, 90, 20),  # from the left
        (160, 125, 270, 20),  # from the right
        (110, 110, 45, 10 * sqrt(2)),  # the lower left corner
        (150, 140, 225, 10 * sqrt(2)),  # the upper right corner
        (110, 140, 135, 10 * sqrt(2)),  # the upper left corner
        (150, 110, 315, 10 * sqrt(2)),  # the lower right corner
        (120, 100, 0, 20),  # along the left side: a graze ends the ray
        (140, 100, 0, 20),  # along the right side
        (100, 120, 90, 20),  # along the lower side
        (100, 130, 90, 20),  # along the upper side
        (119.999, 100, 0, 100),  # just past
        (140.001, 100, 0, 100),
        (130, 140, 0, 60),  # the box is behind
        (130, 110, 180, 110),
        (150, 125, 90, 50),
        (110, 125, 270, 110),
        (100, 119.999, 90, 100),
        (105, 105, 46, 15 / cos(radians(46))),  # into the lower side, just past the corner
        (105, 105, 44, 15 / sin(radians(44))),  # into the left side
    ],
)
def test_a_ray_against_one_box(x: float, y: float, heading: float, cm: float) -> None:
    assert ahead(x, y, heading, BOX) == pytest.approx(cm, abs=1e-6)


def test_the_nearest_of_several_boxes_ends_the_ray() -> None:
    boxes = [(100.0, y, 110.0, y + 5) for y in (150.0, 120.0, 180.0)]
    assert ahead(105, 100, 0, *boxes) == 20


def test_the_beams_fan_out_clockwise() -> None:
    """A wall 50 cm ahead of the robot: each beam is longer by 1 / cos of its angle."""
    wall = (0.0, 150.0, 200.0, 158.0)
    seen = distances([wall], 100, 100, 0, BEAMS)
    assert seen == pytest.approx([50 / cos(radians(angle)) for angle in ANGLES_DEG])
    post = (112.0, 130.0, 116.0, 134.0)  # right of straight ahead
    seen = distances([post], 100, 100, 0, BEAMS)
    assert [cm < 40 for cm in seen] == [False] * 7 + [True]


on_mat = st.floats(1, 199)


@given(on_mat, on_mat, st.floats(0, 360), st.integers(0, 7))
def test_a_ray_ends_on_an_edge_of_the_mat_in_its_own_direction(
    x: float, y: float, heading: float, beam: int
) -> None:
    cm = distances([], x, y, heading, BEAMS)[beam]
    angle = radians(heading + ANGLES_DEG[beam])
    end = (x + cm * sin(angle), y + cm * cos(angle))
    assert min(abs(end[0]), abs(end[1]), abs(200 - end[0]), abs(200 - end[1])) < 1e-6
    assert min(end) > -1e-6
    assert max(end) < 200 + 1e-6


@given(on_mat, on_mat, st.floats(0, 360))
def test_a_ray_into_a_box_ends_on_its_border(x: float, y: float, heading: float) -> None:
    left, low, right, high = BOX
    if left <= x <= right and low <= y <= high:
        assert ahead(x, y, heading, BOX) == 0
        return
    cm = ahead(x, y, heading, BOX)
    free = ahead(x, y, heading)
    angle = radians(heading)
    end = (x + cm * sin(angle), y + cm * cos(angle))
    on_box = left - 1e-6 <= end[0] <= right + 1e-6 and low - 1e-6 <= end[1] <= high + 1e-6
    assert cm <= free
    assert on_box or cm == free
    # Half way there the ray is still outside.
    half = (x + cm / 2 * sin(angle), y + cm / 2 * cos(angle))
    assert not (left < half[0] < right and low < half[1] < high)


def test_a_direction_is_rounded_so_that_engines_agree() -> None:
    assert exact_direction(90) == (1.0, 0.0)
    assert exact_direction(180) == (0.0, -1.0)
    east, north = exact_direction(45)
    assert east == north


def test_nothing_in_range_reads_exactly_the_maximum() -> None:
    chance = generator(1, "depth")
    assert [read(200.001, chance), read(283, chance)] == [RANGE_CM, RANGE_CM]
    # and has used up no chance
    assert chance.random() == generator(1, "depth").random()


def test_readings_spread_as_the_sensor_does_and_are_in_millimetres() -> None:
    chance = generator(3, "depth")
    readings = [read(100, chance) for _ in range(4000)]
    mean = sum(readings) / len(readings)
    spread = sqrt(sum((cm - mean) ** 2 for cm in readings) / len(readings))
    assert mean == pytest.approx(100, abs=0.15)
    assert spread == pytest.approx(DEPTH_SD_CM, rel=0.05)
    assert all(cm == round(cm, 1) for cm in readings)


@given(st.floats(0, 200), st.integers())
def test_readings_stay_in_range(true_cm: float, seed: int) -> None:
    assert 0 <= read(true_cm, generator(seed, "depth")) <= 200


def test_each_noise_has_its_own_sequence_and_each_seed_too() -> None:
    first = {generator(seed, name).random() for seed in (1, 2) for name in ("depth", "feet")}
    assert len(first) == 4
