# earns: the mat has four walls
# How wrong is a map?
#
# A few black cells of a map of this hall, and what
# really stands there. Count the cells that have nothing
# real near. The wrong ones are drawn in red.

from bugbot import *
import math

MAT = 200  # side of the mat [cm]
CELL = 5  # cm per cell


# ---- your part ----
def gap(x, y, real):
    best = min(x, y)
    for left, bottom, width, height in real:
        dx = max(left - x, 0, x - left - width)
        dy = max(bottom - y, 0, y - bottom - height)
        best = min(best, math.hypot(dx, dy))
    return best


def wrong_percent(occupied, real):
    if not occupied:
        return 0
    return 100 * sum(gap(x, y, real) > CELL for x, y in occupied) / len(occupied)


# ---- end of your part ----

# What really stands in the hall: left, bottom, width, height.
REAL = [
    (88, 94, 12, 12),
    (130, 150, 50, 8),
    (20, 145, 30, 30),
    (150, 35, 8, 45),
    (40, 25, 50, 8),
]
black = [(132.5, 147.5), (142.5, 147.5), (152.5, 147.5), (147.5, 62.5)]
black += [(2.5, 102.5), (7.5, 102.5), (152.5, 137.5), (137.5, 62.5)]
draw("occupied", black, "black", "squares", CELL)
draw("wrong", [p for p in black if (gap(*p, REAL) or 0) > CELL], "red", "dots", 3)
print(f"wrong: {wrong_percent(black, REAL)} %")
