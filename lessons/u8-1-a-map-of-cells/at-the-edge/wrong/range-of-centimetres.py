# earns: range() holds whole numbers only
# At the edge
#
# Write index_of, then press Run. Each red dot
# on the mat should get its cell, the others
# none.

from bugbot import *
import math

CELL = 10  # cm per cell
ACROSS = 20  # cells in a row, and in a column


def cell_of(x, y):
    """The (column, row) that holds a point."""
    return math.floor(x / CELL), math.floor(y / CELL)


def index_of(x, y):
    """A point's index in the list, or None."""
    column, row = cell_of(x, y)
    index = row * ACROSS + column
    if x not in range(0, ACROSS * CELL) or y not in range(0, ACROSS * CELL):
        index = None
    return index


# From here on the program only shows what index_of does.
POINTS = [(105, 105), (3, 64), (195, 5), (120, 195), (207, 44), (60, 204), (-4, 150), (150, -6)]
grid = ["bare"] * (ACROSS * ACROSS)

draw("points", POINTS, "red", "dots", 3)
for x, y in POINTS:
    index = index_of(x, y)
    print(f"point ({x}, {y}): {index}")
    if index is not None and -len(grid) <= index < len(grid):
        grid[index] = "marked"
    elif index is not None:
        print(f"  the list has no index {index}")
    wait(0.5)
    marked = [i for i in range(len(grid)) if grid[i] == "marked"]
    middles = [((i % ACROSS + 0.5) * CELL, (i // ACROSS + 0.5) * CELL) for i in marked]
    draw("cells", middles, "#9ecae1", "squares", CELL)
    draw("points", POINTS, "red", "dots", 3)
