# How far a search looks
#
# Yellow: the cells that the search has looked at before it
# found the way. Green: the way. With ESTIMATE = 0 it is
# Dijkstra's algorithm, with 1 it is A*.

from bugbot import *
from heapq import heappop, heappush
from itertools import pairwise
from math import dist

# Numbers to change
ESTIMATE = 1  # how much the distance still to go counts (0 to 5)
GOAL_X = 110  # where the goal is, cm (10 to 190)
GOAL_Y = 120  # (10 to 190)

CELL, ACROSS = 5, 40
STEPS = [(c, r) for c in (-1, 0, 1) for r in (-1, 0, 1) if (c, r) != (0, 0)]
walls = {(column, 15) for column in range(10, 32)} | {(31, row) for row in range(15, 27)}
room = {(column, row) for row in range(ACROSS) for column in range(ACROSS)} - walls


def centre(cell):
    return (cell[0] + 0.5) * CELL, (cell[1] + 0.5) * CELL


def find_way(start, goal):
    """A way through the cells with room, and the cells that were looked at."""
    length, before, looked_at = {start: 0}, {start: None}, []
    waiting = [(0, start)]
    while waiting:
        cell = heappop(waiting)[1]
        if cell in looked_at:
            continue
        looked_at.append(cell)
        if cell == goal:
            way = []
            while cell:
                way.append(cell)
                cell = before[cell]
            return way[::-1], looked_at
        for c, r in STEPS:
            new = cell[0] + c, cell[1] + r
            if {new, (new[0], cell[1]), (cell[0], new[1])} <= room:
                so_far = length[cell] + dist(cell, new)
                if so_far < length.get(new, 1e9):
                    length[new], before[new] = so_far, cell
                    heappush(waiting, (so_far + ESTIMATE * dist(new, goal), new))
    return [], looked_at


goal = int(GOAL_X / CELL), int(GOAL_Y / CELL)
way, looked_at = find_way((20, 5), goal)
draw("walls", [centre(cell) for cell in sorted(walls)], "black", "squares", CELL)
for count in range(0, len(looked_at), 40):
    draw("looked at", [centre(cell) for cell in looked_at[:count]], "gold", "squares", CELL)
    wait(0.1)
draw("looked at", [centre(cell) for cell in looked_at], "gold", "squares", CELL)
draw("way", [centre(cell) for cell in way], "green", "line", 2)
print("looked at:", len(looked_at), "cells")
print("way:", round(sum(dist(a, b) for a, b in pairwise(way)) * CELL, 1), "cm")
