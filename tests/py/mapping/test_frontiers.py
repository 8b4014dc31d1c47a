"""States, frontiers, regions and goals on maps drawn as text."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bugbot.errors import WrongValueError
from mapping.frontiers import (
    State,
    choose_goal,
    clear_line,
    frontier_cells,
    known_states,
    regions,
    states_by_probability,
    three_states,
)
from mapping.grid import Grid

SIGNS = {".": State.FREE, "#": State.OCCUPIED, " ": State.UNKNOWN, "?": State.UNKNOWN}


def drawn(picture):
    """Grid and states of a square picture: `.` free, `#` occupied, `?` unknown, top row first."""
    lines = picture.split()
    grid = Grid(200 / len(lines))
    return grid, [SIGNS[sign] for line in reversed(lines) for sign in line]


maps = st.integers(2, 8).flatmap(
    lambda across: st.lists(
        st.sampled_from(list(State)), min_size=across**2, max_size=across**2
    ).map(lambda states: (Grid(200 / across), states))
)


def test_three_states_between_two_thresholds():
    states = three_states([-2, -1, 0, 1, 2], free_below=-1, occupied_above=1)
    assert states == [State.FREE, State.UNKNOWN, State.UNKNOWN, State.UNKNOWN, State.OCCUPIED]


def test_known_means_log_odds_beyond_one():
    assert known_states([-1.01, 1, 1.01]) == [State.FREE, State.UNKNOWN, State.OCCUPIED]


def test_thresholds_as_probabilities():
    # ln(0.65 / 0.35) is 0.619: one hit of 0.85 is enough, one pass of 0.4 is not, two are.
    assert states_by_probability([0.85, -0.4, -0.8]) == [
        State.OCCUPIED,
        State.UNKNOWN,
        State.FREE,
    ]


def test_a_cell_can_not_be_free_and_occupied():
    with pytest.raises(WrongValueError, match="three_states wants free_below at or under"):
        states_by_probability([0], free_p=0.7, occ_p=0.6)


def test_the_values_are_those_of_a_ros_map():
    assert (State.UNKNOWN, State.FREE, State.OCCUPIED) == (-1, 0, 100)


def test_a_frontier_cell_is_free_and_shares_a_side_with_the_unknown():
    grid, states = drawn("""
        ???
        .#.
        ...
    """)
    assert frontier_cells(grid, states) == {3, 5}


def test_touching_the_unknown_at_a_corner_is_not_enough():
    grid, states = drawn("""
        ..?
        ..#
        ...
    """)
    assert frontier_cells(grid, states) == {7}


def test_the_mats_edge_is_no_frontier():
    grid, states = drawn("""
        ..
        ..
    """)
    assert frontier_cells(grid, states) == set()


def test_regions_hang_together_by_sides_not_corners():
    grid = Grid(50)  # 4 by 4
    assert regions(grid, [0, 1, 4, 10, 15, 11]) == [[0, 1, 4], [10, 11, 15]]
    assert regions(grid, [0, 14, 15]) == [[14, 15], [0]], "the largest first"
    assert regions(grid, [0, 5, 10]) == [[0], [5], [10]]
    assert regions(grid, [3, 4]) == [[3], [4]], "the end of a row is not beside the next one"
    assert regions(grid, []) == []


@given(maps)
def test_every_frontier_cell_is_in_exactly_one_region(drawing):
    grid, states = drawing
    frontier = frontier_cells(grid, states)
    groups = regions(grid, frontier)
    assert sorted(cell for group in groups for cell in group) == sorted(frontier)
    for group in groups:
        for cell in group:
            assert states[cell] is State.FREE
            outside = frontier.difference(group)
            assert outside.isdisjoint(grid.beside(cell))


DOORWAY = """
    ????????
    ???..???
    ???..???
    ###..###
    ........
    ........
    ........
    ........
"""


def test_a_straight_line_needs_free_cells_all_the_way():
    grid, states = drawn(DOORWAY)  # cells of 25 cm
    assert clear_line(grid, states, (100, 25), (100, 160), spare_cm=6)
    assert clear_line(grid, states, (37.5, 37.5), (162.5, 37.5), spare_cm=6)
    assert not clear_line(grid, states, (37.5, 37.5), (37.5, 160), spare_cm=6), "a wall"
    assert not clear_line(grid, states, (100, 25), (100, 190), spare_cm=6), "not known yet"


def test_a_straight_line_keeps_clear_of_walls():
    grid, states = drawn(DOORWAY)
    # The middles of the door posts are at x = 62.5 and 137.5; each counts as 12.5 cm round.
    assert clear_line(grid, states, (100, 90), (100, 160), spare_cm=25)
    assert not clear_line(grid, states, (100, 90), (100, 160), spare_cm=26)
    assert not clear_line(grid, states, (81, 90), (81, 160), spare_cm=6.5)


def test_a_goal_keeps_clear_of_the_mats_edge():
    grid, states = drawn("..\n..")
    assert clear_line(grid, states, (100, 100), (100, 194), spare_cm=6)
    assert not clear_line(grid, states, (100, 100), (100, 195), spare_cm=6)


def test_a_robot_that_is_there_already_can_stay():
    grid, states = drawn("..\n..")
    assert clear_line(grid, states, (50, 50), (50, 50))


def test_the_goal_is_the_nearest_cell_that_can_be_reached():
    grid, states = drawn(DOORWAY)
    # Beyond the doorway the two upper rows are frontier, four cells in one region; the
    # lower of them are nearer, and of these two the left one has the lower index.
    assert choose_goal(grid, states, (100, 37.5), min_region=4) == (87.5, 137.5)
    assert choose_goal(grid, states, (112.5, 37.5), min_region=4) == (112.5, 137.5)


def test_small_regions_are_left_out():
    grid, states = drawn(DOORWAY)
    assert choose_goal(grid, states, (100, 37.5), min_region=5) is None


def test_no_goal_that_the_robot_does_not_fit_through_to():
    grid, states = drawn(DOORWAY)
    assert choose_goal(grid, states, (100, 37.5), min_region=4, spare_cm=26) is None


def test_a_map_without_unknown_cells_is_done():
    grid, states = drawn("...\n.#.\n...")
    assert choose_goal(grid, states, (30, 30), min_region=1) is None
