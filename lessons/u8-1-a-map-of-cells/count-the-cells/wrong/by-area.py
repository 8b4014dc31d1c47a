# earns: areas were divided
# Count the cells
#
# Write count_cells. The program then lays as many cells as you count, row after
# row. If the count is right they cover the mat, and there are no more of them.

from bugbot import *
import math

SIDE = 30  # the side of a cell, in cm (10 to 100)
MAT = 200  # the side of the mat, in cm


def count_cells(side):
    """How many square cells of this side, in cm, it takes to cover the whole mat."""
    count = math.ceil(MAT * MAT / (side * side))
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
