# earns: doubled
# Count the cells
#
# Write count_cells, then press Run. So many
# cells are laid; they should just cover the
# mat.

from bugbot import *
import math

SIDE = 30  # cm per cell (10 to 100)
MAT = 200  # side of the mat, in cm


def count_cells(side):
    """How many cells cover the whole mat."""
    count = math.ceil(MAT / side) * 2
    return count


# From here on the program only shows what count_cells does.
count = count_cells(SIDE)
print(f"cells of {SIDE} cm: {count}")
laid, left, bottom = [], 0, 0
for cell in range(int(count)):
    laid.append((left + SIDE / 2, bottom + SIDE / 2))
    draw("cells", laid, "#9ecae1", "squares", SIDE - 1)
    wait(0.05)
    left += SIDE
    if left >= MAT:  # this row is full
        left, bottom = 0, bottom + SIDE
if bottom >= MAT and left == 0:
    print("They cover the mat to its top edge.")
elif bottom < MAT:
    print(f"They leave bare mat above y = {bottom} cm.")
