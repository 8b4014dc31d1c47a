# earns: x is right, y is not: only the half was multiplied
# Centre of a cell
#
# Write centre_of, then press Run. There
# should be a red dot in the middle of every
# outline.

from bugbot import *
import math

CELL = 10  # cm per cell


def centre_of(column, row):
    """The middle (x, y) of a cell, in cm on the mat."""
    # ---- your part ----
    x = (column + 0.5) * CELL
    y = row + 0.5 * CELL
    # ---- end of your part ----
    return x, y


# From here on the program only shows what centre_of does.
CELLS = [(0, 0), (3, 7), (10, 10), (15, 2), (19, 19)]

for number, (column, row) in enumerate(CELLS, start=1):
    left, bottom = column * CELL, row * CELL
    right_side, top = left + CELL, bottom + CELL
    outline = [(left, bottom), (right_side, bottom), (right_side, top), (left, top), (left, bottom)]
    draw(f"cell {number}", outline, "blue", "line", 1)
middles = []
for column, row in CELLS:
    middles.append(centre_of(column, row))
    print(f"column {column}, row {row}: the middle is {middles[-1]}")
    draw("middles", middles, "red", "dots", 3)
    wait(0.5)
