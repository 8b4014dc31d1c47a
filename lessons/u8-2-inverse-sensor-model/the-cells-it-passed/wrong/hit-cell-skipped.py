# earns: leaves out the cell there
# The cells it passed
#
# Write cells_passed, then press Run. The
# cells should follow the red beam.

from bugbot import *
import math

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row, and in a column
START = (100, 40)  # where the robot starts on the mat


def cells_passed(x, y, angle, reading):
    """The list of cells that a beam passed."""
    cells = []
    # ---- your part ----
    along = 0
    hit = cell_of(*end_of_beam(x, y, angle, reading))
    while along < reading:
        cell = cell_of(*end_of_beam(x, y, angle, along))
        if cell is not None and cell != hit:
            cells.append(cell)
        along += CELL / 2
    # ---- end of your part ----
    return cells


# These two are for you to use.
def end_of_beam(x, y, angle, length):
    """The point so many cm along a beam."""
    direction = math.radians(angle)
    return x + length * math.sin(direction), y + length * math.cos(direction)


def cell_of(x, y):
    """The (column, row) of a point, or None."""
    column = math.floor(x / CELL)
    row = math.floor(y / CELL)
    if 0 <= column < ACROSS and 0 <= row < ACROSS:
        return column, row
    return None


# From here on the program only shows what cells_passed does.
angle, reading = scan()[7]  # the beam furthest to the right
cells = cells_passed(*START, heading() + angle, reading)
middles = []
for column, row in cells:
    middles.append(((column + 0.5) * CELL, (row + 0.5) * CELL))
    draw("passed", middles, "#9ecae1", "squares", CELL)
    wait(0.05)
draw("beam", [START, end_of_beam(*START, heading() + angle, reading)], "red", "line", 0.7)
print(f"reading: {reading:.1f} cm, different cells passed: {len(set(middles))}")
