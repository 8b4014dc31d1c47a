# earns: the distance is counted in cells
# Where to go
#
# Three regions of frontier cells are given, and the
# robot's own cell. Your functions choose a cell to go to.
# Red: what they choose when only nearness counts. Green:
# when size counts too.

from bugbot import *
from math import dist

CELL = 10  # cm per cell: large ones, to be seen easily
ACROSS = 20  # cells in a row


# ---- your part ----
def nearest_cell(here, region):
    return min(region, key=lambda cell: dist(here, cell))


def choose(here, regions, gain):
    def worth(region):
        return gain * len(region) - CELL * dist(here, nearest_cell(here, region))

    if not regions:
        return None
    return nearest_cell(here, max(regions, key=worth))


# ---- end of your part ----


# The rest is done.
here = (10, 2)
regions = [
    {(15, 5), (16, 5), (17, 5)},
    {(4, 9), (4, 10), (4, 11), (5, 12), (5, 13), (5, 14), (6, 15)},
    {(12, 17), (13, 17), (14, 17), (15, 17)},
]


def centre(cell):
    """The middle of a cell in cm on the mat."""
    return (cell[0] + 0.5) * CELL, (cell[1] + 0.5) * CELL


for number, region in enumerate(regions):
    draw(f"region {number}", [centre(cell) for cell in sorted(region)], "gold", "squares", CELL)
for gain, colour in [(0, "red"), (1, "green")]:
    goal = choose(here, regions, gain)
    print("with a gain of", gain, "the goal is", goal)
    if goal is not None:
        draw(f"goal, gain {gain}", [centre(here), centre(goal)], colour, "line", 1)
        draw(f"goal with gain {gain}", [centre(goal)], colour, "dots", 6)
