"""Maps against the truth, cell by cell."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mapping.frontiers import State
from mapping.grid import Grid
from mapping.score import gap_cm, score

BOX = (100, 80, 40, 20)
"""x from 100 to 140, y from 80 to 100."""


def marked(cell_cm, occupied=(), free=()):
    """A grid and states with the cells that hold these points marked."""
    grid = Grid(cell_cm)
    states = [State.UNKNOWN] * len(grid.cells)
    for points, state in ((occupied, State.OCCUPIED), (free, State.FREE)):
        for point in points:
            states[grid.index_at(*point)] = state
    return grid, states


@pytest.mark.parametrize(
    ("point", "gap"),
    [
        ((120, 90), 0),  # inside
        ((100, 80), 0),  # its corner
        ((120, 110), 10),  # above
        ((90, 90), 10),  # to the left
        ((143, 104), 5),  # off the corner: 3, 4, 5
        ((120, 4), 4),  # nearer to the mat's edge
        ((2, 199), 1),  # a corner of the mat
    ],
)
def test_the_gap_to_the_nearest_real_thing(point, gap):
    assert gap_cm(*point, [BOX]) == pytest.approx(gap)


def test_counts_and_shares():
    grid, states = marked(50, occupied=[(110, 90), (10, 10)], free=[(60, 60), (60, 110), (60, 160)])
    result = score(grid, states, [BOX])
    assert (result.cells, result.free, result.occupied) == (16, 3, 2)
    assert result.known_percent == pytest.approx(100 * 5 / 16)
    assert result.wrong_walls_percent == 0


@pytest.mark.parametrize(
    ("point", "wrong"),
    [
        ((102, 90), False),  # in the box
        ((97, 90), False),  # in front of it: middle 2.5 cm away
        ((92, 90), True),  # one further: middle 7.5 cm away
        ((97, 77), False),  # off its corner: middle 3.5 cm away
        ((92, 77), True),  # the knight's move from it: 7.9 cm away
    ],
)
def test_a_wall_is_wrong_further_than_one_cell_from_an_obstacle(point, wrong):
    grid, states = marked(5, occupied=[point])
    result = score(grid, states, [BOX])
    assert result.wrong_walls == ((grid.index_at(*point),) if wrong else ())
    assert result.wrong_walls_percent == (100 if wrong else 0)


@pytest.mark.parametrize("along", [2, 22, 102, 197])
def test_at_the_mats_edge_the_outermost_cells_are_right_and_the_next_are_wrong(along):
    outermost = [(along, 2), (along, 197), (2, along), (197, along)]
    grid, states = marked(5, occupied=outermost)
    assert score(grid, states, []).wrong_walls == ()


@pytest.mark.parametrize("point", [(102, 7), (102, 192), (7, 102), (192, 102)])
def test_the_second_row_from_the_edge_is_wrong(point):
    grid, states = marked(5, occupied=[point])
    assert score(grid, states, []).wrong_walls == (grid.index_at(*point),)


def test_an_obstacle_that_is_not_a_multiple_of_cells():
    post = (130, 70, 8, 70)  # its right side is at x = 138
    grid, states = marked(5, occupied=[(142, 100), (147, 100)])
    assert score(grid, states, [post]).wrong_walls == (grid.index_at(147, 100),)


def test_exactly_one_cell_away_is_not_further():
    grid, states = marked(5, occupied=[(97, 90)])
    assert score(grid, states, [(102.5, 80, 40, 20)]).wrong_walls == ()


def test_floor_inside_an_obstacle_is_wrong_floor():
    grid, states = marked(10, free=[(105, 85), (95, 85), (105, 105)])
    assert gap_cm(105, 105, [(100, 80, 40, 24.5)]) == 0.5
    assert score(grid, states, [(100, 80, 40, 24.5)]).wrong_floor == (grid.index_at(105, 85),)


def test_a_map_of_nothing_scores_nothing():
    grid, states = marked(5)
    result = score(grid, states, [BOX])
    assert (result.known_percent, result.wrong_walls_percent) == (0, 0)


@given(st.integers(5, 50), st.floats(0, 199), st.floats(0, 199))
def test_the_cell_that_holds_a_wall_is_never_wrong(cell_cm, x, y):
    # Its middle is at most half a diagonal, 0.71 of a cell, from the wall's own corner.
    wall = (x, y, 1, 1)
    grid, states = marked(cell_cm, occupied=[(x, y)])
    assert score(grid, states, [wall]).wrong_walls == ()
