# earns: these are the fewest steps
# A way round
#
# The red dot can't be reached in a straight line.
# Your function finds the shortest route through the cells
# with room: a green line.

from bugbot import *
from heapq import heappop, heappush
from itertools import pairwise
from math import dist

CELL = 10  # cm per cell: large ones, to be seen easily
ACROSS = 20  # cells in a row
SIDES = [(-1, 0), (1, 0), (0, -1), (0, 1)]
CORNERS = [(-1, -1), (1, -1), (-1, 1), (1, 1)]


# ---- your part ----
def find_way(start, goal, room):
    """The shortest route from cell to cell: a list of cells.

    start, goal: cells (column, row), both in room. room: a
    set of cells. A step goes to one of the eight cells
    around. A step to a corner is only allowed if both cells
    beside it have room too. The list begins with start and ends
    with goal. It is empty if there is no route.
    """
    before = {start: None}
    queue = [start]
    for cell in queue:
        column, row = cell
        for c, r in CORNERS + SIDES:
            new = column + c, row + r
            if new not in before and {new, (column + c, row), (column, row + r)} <= room:
                before[new] = cell
                queue.append(new)
    way = []
    while goal in before:
        way.append(goal)
        goal = before[goal]
    return way[::-1]


# ---- end of your part ----


# The rest is done.
MAP = """
####################
#..................#
#..................#
#..................#
#..................#
#....#########.....#
#.........#........#
#.........#........#
#.........#........#
######....#...######
#.........#........#
#.........#........#
#.........#........#
#.........#........#
#.........######...#
#..................#
#..................#
#..................#
#..................#
####################
"""
rows = MAP.split()[::-1]  # the lowest row first
room = {(c, r) for r in range(ACROSS) for c in range(ACROSS) if rows[r][c] == "."}


def centre(cell):
    """The middle of a cell in cm on the mat."""
    return (cell[0] + 0.5) * CELL, (cell[1] + 0.5) * CELL


draw("room", [centre(cell) for cell in sorted(room)], "#9ecae1", "squares", CELL)
way = find_way((9, 2), (13, 13), room)
draw("goal", [centre((13, 13))], "red", "dots", 6)
draw("way", [centre(cell) for cell in way], "green", "line", 2)
print(len(way), "cells,", round(sum(dist(a, b) for a, b in pairwise(way)) * CELL), "cm")
