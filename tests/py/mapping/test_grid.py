"""Cells of the mat, on grids of 2 by 2 and 3 by 3."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bugbot.errors import WrongValueError
from mapping.grid import Grid

sizes = st.floats(1, 200)


def three_by_three() -> Grid:
    """Cells of 67 cm: the third column and row hang 1 cm over the edge."""
    return Grid(67)


def test_row_0_is_at_the_bottom_and_columns_run_fastest():
    grid = three_by_three()
    assert [grid.cell(index) for index in range(4)] == [(0, 0), (1, 0), (2, 0), (0, 1)]
    assert grid.index((1, 2)) == 7


def test_the_cell_that_holds_a_point():
    grid = three_by_three()
    assert grid.index_at(0, 0) == 0
    assert grid.index_at(66.999, 0) == 0
    assert grid.index_at(67, 0) == 1, "a line belongs to the cell to its right"
    assert grid.index_at(0, 67) == 3, "and to the cell above"
    assert grid.index_at(199.999, 199.999) == 8


def test_the_last_sliver_of_the_mat_is_in_the_last_cell():
    grid = Grid(1.9999999999999716)  # 100 of them end 3e-12 cm before the edge
    assert grid.across == 100
    assert grid.index_at(199.99999999999997, 0) == 99
    assert grid.index_at(0, 199.99999999999997) == 9900


@pytest.mark.parametrize("point", [(-0.001, 5), (5, -0.001), (200, 5), (5, 200), (1e9, 5)])
def test_beyond_the_mat_is_no_cell(point):
    assert three_by_three().index_at(*point) is None


def test_no_index_runs_on_into_the_next_row():
    grid = three_by_three()
    for cell in [(3, 0), (-1, 1), (0, 3), (0, -1)]:
        with pytest.raises(WrongValueError, match=r"index\(cell\) wants .* from 0 to 2; it got"):
            grid.index(cell)
    for index in (-1, 9):
        with pytest.raises(WrongValueError, match=r"cell\(index\) wants .* from 0 to 8; it got"):
            grid.cell(index)


def test_cells_beside_a_corner_an_edge_and_the_middle():
    grid = three_by_three()
    assert sorted(grid.beside(0)) == [1, 3]
    assert sorted(grid.beside(5)) == [2, 4, 8]
    assert sorted(grid.beside(4)) == [1, 3, 5, 7]


@pytest.mark.parametrize("cell_cm", [0, -5, 0.5, 201, float("nan")])
def test_a_cell_size_that_makes_no_grid_is_refused(cell_cm):
    with pytest.raises(WrongValueError, match=r"Grid\(cell_cm\) wants a number from 1 to 200"):
        Grid(cell_cm)


def test_how_many_cells_for_a_size():
    assert {size: Grid(size).across for size in (5, 8, 20, 30, 200)} == {
        5: 40,
        8: 25,
        20: 10,
        30: 7,
        200: 1,
    }


@given(sizes, st.data())
def test_index_and_cell_undo_each_other(cell_cm, data):
    grid = Grid(cell_cm)
    index = data.draw(st.integers(0, len(grid.cells) - 1))
    assert grid.index(grid.cell(index)) == index


@given(st.integers(1, 200).filter(lambda size: 200 % size == 0), st.data())
def test_the_centre_of_a_cell_lies_in_it(cell_cm, data):
    grid = Grid(cell_cm)
    index = data.draw(st.integers(0, len(grid.cells) - 1))
    assert grid.index_at(*grid.centre(index)) == index


@given(sizes, st.floats(0, 200, exclude_max=True), st.floats(0, 200, exclude_max=True))
def test_every_point_of_the_mat_is_half_a_cell_from_its_cells_centre(cell_cm, x, y):
    grid = Grid(cell_cm)
    index = grid.index_at(x, y)
    assert index is not None
    centre = grid.centre(index)
    assert abs(centre[0] - x) <= cell_cm / 2 + 1e-9
    assert abs(centre[1] - y) <= cell_cm / 2 + 1e-9
