import doctest

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bugbot import frames
from bugbot.frames import (
    cell_centre,
    cell_of,
    cells_across,
    direction,
    turn_between,
    wrap_heading,
)

headings = st.floats(-1e6, 1e6)
on_mat = st.floats(0, 200, exclude_max=True)
sizes = st.sampled_from([1, 2, 2.5, 4, 5, 8, 10, 20, 30])


def test_examples_in_the_docstrings_run() -> None:
    assert doctest.testmod(frames).failed == 0


@pytest.mark.parametrize(
    ("heading", "way"), [(0, (0, 1)), (90, (1, 0)), (180, (0, -1)), (270, (-1, 0)), (450, (1, 0))]
)
def test_heading_runs_clockwise_from_up_the_mat(heading: float, way: tuple[float, float]) -> None:
    assert direction(heading) == pytest.approx(way, abs=1e-12)


@given(headings)
def test_wrapped_heading_is_in_range_and_points_the_same_way(heading: float) -> None:
    wrapped = wrap_heading(heading)
    assert 0 <= wrapped < 360
    assert direction(wrapped) == pytest.approx(direction(heading), abs=1e-6)


def test_heading_just_below_zero_does_not_wrap_to_360() -> None:
    assert wrap_heading(-1e-20) == 0.0


@given(headings, headings)
def test_turn_between_is_the_short_way_and_arrives(begin: float, end: float) -> None:
    turn = turn_between(begin, end)
    assert -180 < turn <= 180
    assert direction(begin + turn) == pytest.approx(direction(end), abs=1e-6)


def test_half_a_turn_is_clockwise() -> None:
    assert turn_between(0, 180) == 180
    assert turn_between(90, 270) == 180


@pytest.mark.parametrize(
    ("point", "cell"),
    [
        ((0, 0), (0, 0)),
        ((4.999, 5), (0, 1)),
        ((199.999, 199.999), (39, 39)),
        ((200, 100), None),
        ((100, 200), None),
        ((-0.001, 100), None),
        ((100, -0.001), None),
    ],
)
def test_cell_of_a_point_at_edges_and_beyond(
    point: tuple[float, float], cell: tuple[int, int] | None
) -> None:
    assert cell_of(*point, 5) == cell


@given(on_mat, on_mat, sizes)
def test_point_is_within_half_a_cell_of_its_cells_centre(x: float, y: float, cell: float) -> None:
    place = cell_of(x, y, cell)
    assert place is not None
    centre = cell_centre(*place, cell)
    assert abs(centre[0] - x) <= cell / 2 + 1e-9
    assert abs(centre[1] - y) <= cell / 2 + 1e-9
    assert max(place) < cells_across(cell)


@pytest.mark.parametrize(("cell", "count"), [(5, 40), (20, 10), (30, 7), (200, 1), (0.1, 2000)])
def test_cells_across_counts_the_one_that_hangs_over(cell: float, count: int) -> None:
    assert cells_across(cell) == count
