# earns: True
# A straight way
#
# From where the robot stands, which goals can it reach in
# a straight line without touching a wall? Your function
# decides: green lines are clear, red lines are not.

from bugbot import *
from math import dist, floor

SPARE = 6  # cm from the robot's middle to any wall, at least
CELL = 5  # cm per cell


# ---- your part ----
def straight_way(start, goal, walls):
    steps = max(1, round(dist(start, goal)))
    for i in range(steps + 1):
        x = start[0] + (goal[0] - start[0]) * i / steps
        y = start[1] + (goal[1] - start[1]) * i / steps
        for column, row in walls:
            middle = (column + 0.5) * CELL, (row + 0.5) * CELL
            if dist((x, y), middle) - CELL / 2 < SPARE:
                return False
    return True


# ---- end of your part ----


# The rest is done.
walls = {(column, row) for column in range(40) for row in (24, 25) if not 18 <= column < 22}
goals = [(30, 60), (170, 80), (60, 150), (88, 150), (97, 150), (100, 180), (106, 150), (150, 170)]

middles = [((column + 0.5) * CELL, (row + 0.5) * CELL) for column, row in sorted(walls)]
draw("occupied", middles, "black", "squares", CELL)
for number, goal in enumerate(goals):
    clear = straight_way((100, 25), goal, walls)
    draw(f"way {number}", [(100, 25), goal], "green" if clear else "red", "line", 1)
    print(goal, "clear" if clear else "not clear")
