"""A whole mapper on mats small enough to fill in by hand."""

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from mapping.beam import Weights, end_of_beam, passed_by_bresenham
from mapping.mapper import Mapper

whole = Weights(l_occ=3, l_free=-1, l_max=10)
"""Evidence that is easy to add up."""

poses = st.tuples(st.floats(0, 200), st.floats(0, 200), st.floats(0, 360))
scans = st.lists(st.tuples(st.floats(-30, 30), st.floats(0, 200)), max_size=8)


def rows(mapper):
    """The map as it looks from above: top row first."""
    across = mapper.grid.across
    cells = mapper.grid.cells
    return [cells[row * across : (row + 1) * across] for row in reversed(range(across))]


def test_one_beam_up_the_middle_of_three_by_three():
    mapper = Mapper(67, whole)
    # Clear for 150 - 67 = 83 cm: steps of 33.5 cm at y = 10 and 43.5. The hit is at y = 160.
    mapper.add_beam(100, 10, 0, 150)
    assert rows(mapper) == [[0, 3, 0], [0, 0, 0], [0, -2, 0]]


def test_the_same_beam_by_bresenham_counts_each_cell_once():
    mapper = Mapper(67, whole, passed_by=passed_by_bresenham)
    mapper.add_beam(100, 10, 0, 150)
    assert rows(mapper) == [[0, 3, 0], [0, -1, 0], [0, -1, 0]]


def test_a_reading_of_nothing_marks_no_wall():
    mapper = Mapper(50, whole)
    mapper.add_beam(25, 10, 0, 200)
    # Believed up to 170 cm: steps of 25 cm at y = 10, 35, 60, 85, 110, 135.
    assert rows(mapper) == [[0, 0, 0, 0], [-2, 0, 0, 0], [-2, 0, 0, 0], [-2, 0, 0, 0]]


def test_a_beam_that_ends_at_the_robots_feet_clears_nothing():
    mapper = Mapper(100, whole)
    mapper.add_beam(50, 50, 90, 20)
    assert rows(mapper) == [[0, 0], [3, 0]]


def test_what_lies_beyond_the_mat_is_left_out():
    mapper = Mapper(100, whole)
    mapper.add_beam(50, 150, 0, 51)  # noise has carried the mat's own wall to y = 201
    mapper.add_beam(50, 50, -90, 160)  # a wrong pose looks out of the mat
    # Clear for 60 cm: the steps of 50 cm are at x = 50 only; the hit is at x = -110.
    assert rows(mapper) == [[0, 0], [-1, 0]]


def test_along_the_far_edge_nothing_runs_on_into_the_next_row():
    mapper = Mapper(100, whole)
    mapper.add_beam(150, 50, 90, 180)
    # Clear for 170 cm: steps at x = 150, and at 200 and 250, which are beyond the mat.
    assert rows(mapper) == [[0, 0], [0, -1]]


def test_a_scans_angles_are_added_to_the_heading():
    mapper = Mapper(100, whole)
    mapper.add_scan(150, 150, 180, [(-90, 60), (90, 60)])  # facing down: left is to the right
    assert rows(mapper) == [[3, 0], [0, 0]]
    mapper.add_scan(150, 150, 180, [(0, 60)])
    assert rows(mapper) == [[3, 0], [0, 3]]


def test_sums_are_clamped_as_they_are_added():
    mapper = Mapper(100, Weights(l_occ=3, l_free=-1, l_max=4))
    for _ in range(5):
        mapper.add_beam(50, 50, 0, 100)
    assert rows(mapper) == [[4, 0], [0, 0]]
    mapper.add_beam(50, 150, 0, 180)
    # Passed at y = 150 only, before the edge: one step back from the clamp, not from 15.
    assert rows(mapper)[0][0] == 3


def test_how_many_passes_undo_a_wall_at_the_clamp():
    mapper = Mapper(5)
    for _ in range(20):
        mapper.add_beam(2.5, 2.5, 0, 50)
    wall = mapper.grid.index_at(2.5, 52.5)
    assert mapper.grid.cells[wall] == 8
    looks = 0
    while mapper.grid.cells[wall] > -1:
        mapper.add_beam(2.5, 2.5, 0, 150)
        looks += 1
    assert looks == 12, "9 units, 0.8 a look: two steps lie in the cell"


@given(poses, scans, st.floats(5, 50))
def test_every_sum_stays_between_the_clamps(pose, scan, cell_cm):
    mapper = Mapper(cell_cm, Weights(l_max=2))
    for _ in range(4):
        mapper.add_scan(*pose, scan)
    assert all(-2 <= cell <= 2 for cell in mapper.grid.cells)


@given(poses, scans)
def test_a_map_turned_by_a_quarter_is_the_map_of_the_turned_robot(pose, scan):
    x, y, heading = pose
    # A point on the line between two cells belongs to the upper right one, turned or not.
    assume(not any(_touches_a_line(x, y, heading + angle, cm) for angle, cm in scan))
    here, there = Mapper(40, whole), Mapper(40, whole)
    here.add_scan(x, y, heading, scan)
    # Turning the mat clockwise about its middle takes (x, y) to (y, 200 - x).
    there.add_scan(y, 200 - x, heading + 90, scan)
    for column in range(5):
        for row in range(5):
            turned = there.grid.index((row, 4 - column))
            assert there.grid.cells[turned] == here.grid.cells[here.grid.index((column, row))]


def _touches_a_line(x, y, angle, reading):
    lengths = [reading, *range(0, 180, 20)]  # the hit, and steps of half a cell
    points = [end_of_beam(x, y, angle, length) for length in lengths]
    return any(abs(side / 40 - round(side / 40)) < 1e-9 for point in points for side in point)


@pytest.mark.parametrize("reading", [-1, float("nan")])
def test_a_reading_that_is_no_distance_changes_nothing(reading):
    mapper = Mapper(100)
    with pytest.raises(ValueError, match="a reading wants"):
        mapper.add_beam(50, 50, 0, reading)
    assert set(mapper.grid.cells) == {0.0}
