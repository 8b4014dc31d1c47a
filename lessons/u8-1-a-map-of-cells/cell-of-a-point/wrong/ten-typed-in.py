# earns: 10 is typed in
# Cell of a point
#
# Write cell_of, then press Run. Each red dot
# should get the outline of its own cell.

from bugbot import *
import math

CELL = 10  # cm per cell


def cell_of(x, y):
    """The (column, row) that holds a point."""
    column = math.floor(x / 10)
    row = math.floor(y / 10)
    return column, row


# From here on the program only shows what cell_of does.
POINTS = [(32, 78), (105, 105), (150, 20), (60, 160), (199, 199)]

draw("points", POINTS, "red", "dots", 3)
for number, (x, y) in enumerate(POINTS, start=1):
    column, row = cell_of(x, y)
    print(f"point ({x}, {y}): column {column}, row {row}")
    left, bottom = column * CELL, row * CELL
    right_side, top = left + CELL, bottom + CELL
    outline = [(left, bottom), (right_side, bottom), (right_side, top), (left, top), (left, bottom)]
    draw(f"cell {number}", outline, "blue", "line", 1)
    wait(0.5)
