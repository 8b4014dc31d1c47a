# earns: a step to a corner counts 1.5
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
    length = {start: 0}
    before = {}
    waiting = [(0, start)]
    while waiting:
        cell = heappop(waiting)[1]
        if cell == goal:
            way = [cell]
            while cell != start:
                cell = before[cell]
                way.append(cell)
            return way[::-1]
        column, row = cell
        for c, r in SIDES + CORNERS:
            new = column + c, row + r
            if {new, (column + c, row), (column, row + r)} <= room:
                n = length[cell] + (1.5 if c and r else 1)
                if new not in length or n < length[new]:
                    length[new] = n
                    before[new] = cell
                    heappush(waiting, (n, new))
    return []


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
