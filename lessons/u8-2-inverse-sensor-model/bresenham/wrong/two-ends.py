# earns: only the two ends
# Bresenham's line
#
# Write line_of_cells, then press Run. Every
# line should come out without a gap.

from bugbot import *

CELL = 5  # cm per cell


def line_of_cells(first, last):
    """The cells of a line, ends included."""
    column, row = first
    cells = [(column, row)]
    cells += [last]
    return cells


# From here on the program only shows what line_of_cells does.
MIDDLE = (20, 20)
LASTS = [(33, 24), (25, 37), (14, 33), (5, 26), (3, 11), (17, 1), (27, 9), (36, 13), (20, 38)]

drawn = []
for last in LASTS:
    cells = line_of_cells(MIDDLE, last)
    drawn += [((column + 0.5) * CELL, (row + 0.5) * CELL) for column, row in cells]
    draw("lines", drawn, "#9ecae1", "squares", CELL)
    print(f"from {MIDDLE} to {last}: {len(cells)} cells")
    wait(0.5)
