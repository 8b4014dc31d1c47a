# One list for the whole mat
#
# The cells are numbered row after row from
# the lower left corner. The program shows
# every number in its place, and then finds
# one of them.

from bugbot import *
import math

# Numbers to change
CELL = 25  # cm per cell (20 to 50)
INDEX = 27  # place to look for (0 to 99)

MAT = 200  # side of the mat [cm]
ACROSS = math.ceil(MAT / CELL)
grid = [0] * (ACROSS * ACROSS)


def centre(index):
    """The middle of a cell, in cm on the mat."""
    column = index % ACROSS  # what is left over after whole rows
    row = index // ACROSS  # how many whole rows come before it
    return (column + 0.5) * CELL, (row + 0.5) * CELL


if INDEX < len(grid):
    draw("the one to find", [centre(INDEX)], "#9ecae1", "squares", CELL)
    print(f"place {INDEX}: column {INDEX % ACROSS}, row {INDEX // ACROSS}")
else:
    print(f"there is no place {INDEX}: the last is {len(grid) - 1}")

labels = []
for index in range(len(grid)):
    labels.append((*centre(index), str(index)))
    draw("place in the list", labels, "black", "text", 7)
    wait(0.05)
print(f"{ACROSS} cells across, {len(grid)} in the list")
