# earns: leave one of the two changes out
# A beam without a loop
#
# Write cells_passed with NumPy and without a
# loop, then press Run.

from bugbot import *
import numpy as np

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row, and in a column
START = (100, 40)  # where the robot starts on the mat


def cells_passed(x, y, angle, reading):
    """Rows of (column, row): the cells passed."""
    direction = np.radians(90 - angle)
    along = np.arange(0, reading - CELL, CELL / 2)
    points = np.column_stack([x + along * np.sin(direction), y + along * np.cos(direction)])
    cells = np.floor(points / CELL).astype(int)
    on_the_mat = np.all((cells >= 0) & (cells < ACROSS), axis=1)
    cells = cells[on_the_mat]
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
