"""Room, reach, ways and choices on maps drawn as text."""

from math import dist, hypot, inf, isclose, sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bugbot.errors import WrongValueError
from mapping.frontiers import State, gap_to_walls, regions
from mapping.grid import Grid
from mapping.planning import (
    choose_region,
    look_out,
    reachable,
    room_cells,
    shortest_way,
    way_cm,
)

SIGNS = {".": State.FREE, "#": State.OCCUPIED, "?": State.UNKNOWN}


def drawn(picture):
    """Grid and states of a square picture: `.` free, `#` occupied, `?` unknown, top row first."""
    lines = picture.split()
    return Grid(200 / len(lines)), [SIGNS[sign] for line in reversed(lines) for sign in line]


def free_of(states):
    return {index for index, state in enumerate(states) if state is State.FREE}


DOORWAY = """
    ??.....?
    ??.....?
    ........
    ###..###
    ........
    ........
    ........
    ........
"""


def test_room_keeps_clear_of_walls_of_the_unknown_and_of_the_mats_edge():
    grid, states = drawn(DOORWAY)  # cells of 25 cm
    assert room_cells(grid, states, spare_cm=0) == free_of(states)
    room = room_cells(grid, states, spare_cm=13)  # 25.5 cm from middle to middle: sides only
    assert 4 * 8 + 3 not in room, "beside a door post"
    assert 0 not in room, "at the edge"
    assert 6 * 8 + 2 not in room, "beside the unknown"
    assert 2 * 8 + 3 in room
    assert 6 * 8 + 4 in room


@given(
    st.integers(min_value=2, max_value=9),
    st.floats(min_value=0, max_value=60),
    st.randoms(use_true_random=False),
)
def test_room_is_what_a_look_at_every_pair_of_cells_says(cells, spare_cm, chance):
    grid = Grid(200 / cells)
    states = [
        chance.choice([State.FREE, State.FREE, State.FREE, State.UNKNOWN]) for _ in range(cells**2)
    ]
    around = range(-cells, 2 * cells)  # what follows beyond the edge is not free
    blocked = [
        (column, row)
        for column in around
        for row in around
        if not (0 <= column < cells and 0 <= row < cells)
        or states[row * cells + column] is not State.FREE
    ]
    wanted = {
        row * cells + column
        for column in range(cells)
        for row in range(cells)
        if all(
            hypot(c - column, r - row) * grid.cell_cm >= spare_cm + grid.cell_cm / 2
            for c, r in blocked
        )
    }
    assert room_cells(grid, states, spare_cm) == wanted


def test_room_wants_a_distance():
    grid, states = drawn("..\n..")
    with pytest.raises(WrongValueError, match=r"room_cells.* wants 0 or more .* it got -1"):
        room_cells(grid, states, spare_cm=-1)


def test_what_is_reachable_hangs_together_by_sides():
    grid, states = drawn("""
        ..#.
        ..#.
        ##..
        ..#.
    """)
    assert reachable(grid, 8, free_of(states)) == {8, 9, 12, 13}
    assert reachable(grid, 3, free_of(states)) == {3, 6, 7, 11, 15}


def test_the_way_goes_round_the_wall_and_cuts_no_corner():
    grid, states = drawn("""
        ....
        .##.
        ..#.
        ..#.
    """)
    way = shortest_way(grid, 1, 3, free_of(states))
    assert way[0] == 1
    assert way[-1] == 3
    # One slanting step, two up, three along the top, three down.
    assert isclose(way_cm(grid, way), 50 * (sqrt(2) + 2 + 3 + 3))
    assert 13 in way
    assert 12 in way, "not from (0, 2) to (1, 3), which would cut the corner of the wall"


def test_there_is_no_way_through_a_wall_or_from_a_place_without_room():
    grid, states = drawn("..#.\n..#.\n..#.\n..#.")
    room = free_of(states)
    assert shortest_way(grid, 0, 3, room) == []
    assert shortest_way(grid, 2, 0, room) == []
    assert shortest_way(grid, 0, 0, room) == [0]


rooms = st.sets(st.integers(0, 35))


@given(rooms, st.integers(0, 35), st.integers(0, 35))
def test_a_way_is_as_short_as_a_search_without_an_estimate_finds_it(room, start, goal):
    grid = Grid(200 / 6)
    room |= {start, goal}
    shortest = {start: 0.0}
    for _ in range(36):  # Bellman and Ford: as often as there are cells
        for cell, so_far in list(shortest.items()):
            column, row = grid.cell(cell)
            for new in grid.around(cell):
                to_column, to_row = grid.cell(new)
                sides = {new, grid.index((to_column, row)), grid.index((column, to_row))}
                if sides <= room:
                    length = so_far + way_cm(grid, [cell, new])
                    shortest[new] = min(length, shortest.get(new, inf))
    way = shortest_way(grid, start, goal, room)
    assert bool(way) == (goal in shortest)
    if way:
        assert isclose(way_cm(grid, way), shortest[goal], abs_tol=1e-9)
        assert set(way) <= room
        assert goal in reachable(grid, start, room)


def test_a_region_is_looked_at_from_near_its_middle():
    grid, states = drawn(DOORWAY)
    region = [50, 58]  # (2, 6) and (2, 7)
    assert look_out(grid, region, free_of(states) - {50, 58}, near_cm=26) == 51
    assert look_out(grid, region, [0, 1], near_cm=26) is None


def test_gain_against_distance():
    assert choose_region([4, 9], [50, 100], 5, gain=0) == 0
    assert choose_region([4, 9], [50, 100], 5, gain=3) == 1
    assert choose_region([4, 4], [50, 50], 5, gain=1) == 0
    assert choose_region([], [], 5, gain=1) is None


def test_regions_may_hang_together_by_corners():
    grid = Grid(50)  # 4 by 4
    assert regions(grid, [0, 5, 10], corners=True) == [[0, 5, 10]]
    assert regions(grid, [3, 4], corners=True) == [[3], [4]], "a row's end and the next one's start"


def test_the_gap_between_a_line_and_walls():
    assert gap_to_walls([], 5, (0, 0), (10, 0)) == inf
    assert gap_to_walls([(5, 10), (40, 5)], 5, (0, 0), (10, 0)) == 7.5
    assert gap_to_walls([(13, 4)], 5, (0, 0), (10, 0)) == 2.5, "beyond the end: from the end"


@given(*[st.tuples(*[st.floats(min_value=0, max_value=200)] * 2)] * 3)
def test_the_gap_to_a_line_is_the_least_of_many_points_of_it(wall, here, goal):
    steps = 400
    points = (
        (here[0] + (goal[0] - here[0]) * i / steps, here[1] + (goal[1] - here[1]) * i / steps)
        for i in range(steps + 1)
    )
    least = min(dist(wall, point) for point in points)
    gap = gap_to_walls([wall], 10, here, goal)
    assert gap <= least - 5 + 1e-9
    assert gap >= least - 5 - dist(here, goal) / steps


def test_the_gap_to_a_line_of_no_length_is_the_distance_to_its_point():
    assert gap_to_walls([(30, 40)], 10, (0, 0), (0, 0)) == 45
