"""What one reading says: beams whose cells can be counted on paper."""

from itertools import pairwise
from math import inf, nan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bugbot.errors import WrongValueError
from mapping.beam import (
    Weights,
    bresenham,
    clear_length,
    end_of_beam,
    end_of_hit,
    passed_by_bresenham,
    passed_by_steps,
)

cells = st.tuples(st.integers(-50, 50), st.integers(-50, 50))
places = st.floats(0, 200)
angles = st.floats(-360, 720)


def near(x, y):
    return pytest.approx((x, y), abs=1e-9)


def test_headings_run_clockwise_from_up_the_mat():
    assert end_of_beam(100, 100, 0, 10) == near(100, 110)
    assert end_of_beam(100, 100, 90, 10) == near(110, 100)
    assert end_of_beam(100, 100, 180, 10) == near(100, 90)
    assert end_of_beam(100, 100, -90, 10) == near(90, 100)
    assert end_of_beam(0, 0, 30, 10) == near(5, 75**0.5), "sine for x, cosine for y"


def test_free_floor_stops_one_cell_short_of_a_hit():
    assert clear_length(50, 5) == 45
    assert clear_length(4, 5) == 0
    assert clear_length(0, 5) == 0


def test_a_reading_of_nothing_is_free_floor_as_far_as_it_is_believed():
    assert clear_length(169.9, 5) == pytest.approx(164.9)
    assert clear_length(170, 5) == 170
    assert clear_length(200, 5) == 170


def test_a_hit_is_only_marked_below_170_cm():
    assert end_of_hit(100, 20, 0, 169.9) == near(100, 189.9)
    assert end_of_hit(100, 20, 0, 170) is None
    assert end_of_hit(100, 20, 0, 200) is None


@pytest.mark.parametrize("reading", [-1, nan, -inf])
def test_a_reading_that_is_no_distance_is_refused(reading):
    with pytest.raises(WrongValueError, match="a reading wants a number of 0 or more"):
        clear_length(reading, 5)


@pytest.mark.parametrize(
    "wrong", [{"l_occ": -1}, {"l_free": 0.1}, {"l_max": 0}, {"far_cm": 0}, {"l_max": nan}]
)
def test_weights_that_make_no_sense_are_refused(wrong):
    with pytest.raises(WrongValueError, match="Weights wants l_occ of 0 or more"):
        Weights(**wrong)


def test_steps_name_each_cell_twice_straight_ahead():
    # From the bottom of a column of cells, 20 cm up: steps at 0, 2.5, 5, … 17.5 cm.
    rows = [row for _, row in passed_by_steps(2.5, 0, 0, 20, 5)]
    assert rows == [0, 0, 1, 1, 2, 2, 3, 3]


def test_steps_run_on_beyond_the_mat_for_the_grid_to_drop():
    assert passed_by_steps(2.5, 2.5, -90, 7.5, 5) == [(0, 0), (0, 0), (-1, 0)]


def test_no_length_no_cells():
    assert passed_by_steps(100, 100, 0, 0, 5) == []


def test_bresenham_by_hand():
    assert bresenham((3, 3), (3, 3)) == [(3, 3)]
    assert bresenham((0, 0), (3, 0)) == [(0, 0), (1, 0), (2, 0), (3, 0)]
    assert bresenham((0, 0), (-2, -2)) == [(0, 0), (-1, -1), (-2, -2)]
    assert bresenham((0, 0), (4, 2)) == [(0, 0), (1, 0), (2, 1), (3, 1), (4, 2)], "half way: stay"
    assert bresenham((0, 0), (1, 3)) == [(0, 0), (0, 1), (1, 2), (1, 3)]
    assert bresenham((0, 0), (6, -4)) == [
        (0, 0),
        (1, -1),
        (2, -1),
        (3, -2),
        (4, -3),
        (5, -3),
        (6, -4),
    ]


@given(cells, cells)
def test_a_line_of_cells_has_both_ends_no_gap_and_no_detour(first, last):
    line = bresenham(first, last)
    assert line[0] == first
    assert line[-1] == last
    assert len(line) == 1 + max(abs(last[0] - first[0]), abs(last[1] - first[1]))
    for here, there in pairwise(line):
        assert max(abs(there[0] - here[0]), abs(there[1] - here[1])) == 1


@given(cells, cells)
def test_a_line_of_cells_keeps_within_half_a_cell_of_the_true_line(first, last):
    wide, high = last[0] - first[0], last[1] - first[1]
    longer = max(abs(wide), abs(high))
    for column, row in bresenham(first, last):
        # Distance along the shorter side, times the longer one, so that it is whole.
        off = abs((column - first[0]) * high - (row - first[1]) * wide)
        assert 2 * off <= longer


@given(cells, cells)
def test_a_line_of_cells_is_the_same_in_every_mirror(first, last):
    line = bresenham(first, last)

    def mirrored(mirror):
        return bresenham(mirror(first), mirror(last)) == [mirror(cell) for cell in line]

    assert mirrored(lambda cell: (-cell[0], cell[1]))
    assert mirrored(lambda cell: (cell[0], -cell[1]))
    wide, high = last[0] - first[0], last[1] - first[1]
    if abs(wide) != abs(high):  # a perfect diagonal needs no choice of the longer side
        assert mirrored(lambda cell: (cell[1], cell[0]))


@given(places, places, angles, st.floats(0, 200), st.integers(1, 40))
def test_steps_leave_no_gap_between_cells(x, y, angle, length, cell_cm):
    passed = passed_by_steps(x, y, angle, length, cell_cm)
    for here, there in pairwise(passed):
        assert max(abs(there[0] - here[0]), abs(there[1] - here[1])) <= 1


@given(places, places, angles, st.floats(0, 200), st.integers(1, 40))
def test_steps_name_a_cell_at_most_three_times_in_a_row_and_never_come_back(
    x, y, angle, length, cell_cm
):
    # A cell's diagonal is 2.83 half-cell steps long, so three steps may lie in it.
    passed = passed_by_steps(x, y, angle, length, cell_cm)
    assert all(passed.count(cell) <= 3 for cell in passed)
    runs = [cell for i, cell in enumerate(passed) if i == 0 or passed[i - 1] != cell]
    assert len(runs) == len(set(runs))


@given(places, places, angles, st.floats(0, 200), st.integers(1, 40))
def test_every_step_is_within_a_cell_of_the_line_of_cells(x, y, angle, length, cell_cm):
    # The line goes from middle to middle, the beam from point to point: at every place they
    # are at most half a cell apart along each axis, and rounding adds half a cell more.
    line = passed_by_bresenham(x, y, angle, length, cell_cm)
    for column, row in passed_by_steps(x, y, angle, length, cell_cm):
        assert any(abs(column - c) <= 1 and abs(row - r) <= 1 for c, r in line)


@given(st.integers(0, 39), st.integers(0, 39), st.integers(0, 3), st.integers(0, 30))
def test_along_an_axis_steps_and_bresenham_pass_the_same_cells(column, row, quarter, count):
    middle = (5 * column + 2.5, 5 * row + 2.5)
    length = 5.0 * count + 1  # one cm past the last middle, so that rounding decides nothing
    by_steps = passed_by_steps(*middle, 90 * quarter, length + 2.5, 5)
    assert set(by_steps) == set(passed_by_bresenham(*middle, 90 * quarter, length, 5))
