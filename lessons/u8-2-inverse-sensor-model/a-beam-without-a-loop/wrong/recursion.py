# earns: a function that calls itself, walk()
# A beam without a loop
#
# Write cells_passed with NumPy and without a
# loop, then press Run.

from bugbot import *
import numpy as np

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row, and in a column
START = (100, 40)  # where the robot starts on the mat


def walk(x, y, direction, along, stop):
    """The cells from so far along the beam on."""
    if along >= stop:
        return []
    column = np.floor((x + along * np.sin(direction)) / CELL)
    row = np.floor((y + along * np.cos(direction)) / CELL)
    rest = walk(x, y, direction, along + CELL / 2, stop)
    on_the_mat = 0 <= column < ACROSS and 0 <= row < ACROSS
    return [(column, row), *rest] if on_the_mat else rest


def cells_passed(x, y, angle, reading):
    """Rows of (column, row): the cells passed."""
    cells = np.array(walk(x, y, np.radians(angle), 0, reading - CELL), dtype=int).reshape(-1, 2)
    return cells


# From here on the program only shows what cells_passed does.
grid = np.zeros((ACROSS, ACROSS), dtype=int)
for look in range(9):
    for angle, reading in scan():
        cells = cells_passed(*START, heading() + angle, reading)
        columns, rows = np.array(cells, dtype=int).reshape(-1, 2).T
        np.add.at(grid, (rows, columns), 1)
    rows, columns = np.nonzero(grid)
    middles = (np.column_stack([columns, rows]) + 0.5) * CELL
    draw("passed", middles.tolist(), "#9ecae1", "squares", CELL)
    turn(40)
print("cells passed:", len(middles), "the most often:", grid.max(), "times")
