# earns: has a for loop
# Many points at once
#
# Write cells_of with NumPy and without a
# loop. Cells with a red dot should be
# coloured.

from bugbot import *
import numpy as np

CELL = 10  # cm per cell
ACROSS = 20  # cells in a row, and in a column


def cells_of(points):
    """The cells of the points on the mat."""
    points = np.array(points, dtype=float)
    # points now has one row (x, y) for each point
    kept = []
    for x, y in points:
        column, row = int(np.floor(x / CELL)), int(np.floor(y / CELL))
        if 0 <= column < ACROSS and 0 <= row < ACROSS:
            kept.append((column, row))
    cells = np.array(kept, dtype=int).reshape(-1, 2)
    return cells


# From here on the program only shows what cells_of does.
rng = np.random.default_rng(1)
scattered = rng.uniform(-15, 215, size=(40, 2)).round(1)

cells = np.array(cells_of(scattered.tolist()))
if cells.ndim == 2:
    draw("cells", ((cells + 0.5) * CELL).tolist(), "#9ecae1", "squares", CELL)
else:
    print("not a table with two columns, but an array of shape", cells.shape)
draw("points", scattered.tolist(), "red", "dots", 3)
print("points:", len(scattered))
print("cells of points on the mat:", len(cells))
