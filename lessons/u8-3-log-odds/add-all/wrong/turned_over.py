# earns: rows and columns are swapped in the answer
# A whole scan at once, with NumPy
#
# A beam that crosses a cell names it about twice, and
# each naming is evidence. Your function gets the names
# of many cells at once, with repeats.

from bugbot import *
import numpy as np


def add_all(grid, rows, columns, evidence, limit):
    """The grid with evidence added to each (row, column).

    A cell that is named twice gets it twice. Then the
    whole grid is clamped.
    """
    grid = np.array(grid, dtype=float)  # a copy
    # ---- your part ----
    np.add.at(grid, (rows, columns), evidence)
    grid = np.clip(grid, -limit, limit).T
    # ---- end of your part ----
    return grid


# A beam up the mat: two half-cell steps in each of 20 cells.
rows = [step // 2 for step in range(40)]
columns = [20] * 40
grid = np.zeros((40, 40))
for beam in range(12):
    grid = np.array(add_all(grid, rows, columns, -0.4, 8))
    plot("one cell of the beam", grid[10, 20])
    found = np.argwhere(grid < -1)  # pairs (row, column)
    draw("free", (found[:, ::-1] + 0.5) * 5, "#9ecae1", "squares", 5)
    wait(0.5)
