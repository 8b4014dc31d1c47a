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
    # ---- your part ----
    # At present every beam goes 30 cm up.
    along = np.arange(0, 30, CELL)
    points = np.column_stack([x + 0 * along, y + along])
    cells = np.floor(points / CELL).astype(int)
    # ---- end of your part ----
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
