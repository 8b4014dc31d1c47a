# earns: free has to stay as it was
# Frontier cells
#
# A map, half done, with "." for free, "#" for occupied
# and "?" for unknown. Your function finds the frontier:
# yellow squares.

from bugbot import *

CELL = 10  # cm per cell: large ones, to be seen easily
ACROSS = 20  # cells in a row
SIDES = [(-1, 0), (1, 0), (0, -1), (0, 1)]

MAP = """
?????##########?????
?????..........?????
??????........??????
??????........??????
???????......???????
???????......???????
????????....????????
?#######....#######?
#..................#
#..................#
#..................#
#..................#
#..................#
#.................??
#.................??
#..................#
#..................#
#..................#
#?.................#
????############????
"""


# ---- your part ----
def find_frontier(free, occupied):
    walls = set(occupied)
    free |= walls
    unknown = {(c, r) for c in range(ACROSS) for r in range(ACROSS)} - free
    return {
        (column, row)
        for column, row in free - walls
        if any((column + c, row + r) in unknown for c, r in SIDES)
    }


# ---- end of your part ----


# The rest is done.
rows = MAP.split()[::-1]  # the lowest row first
cells = {(column, row): rows[row][column] for row in range(ACROSS) for column in range(ACROSS)}
free = {cell for cell in cells if cells[cell] == "."}
occupied = {cell for cell in cells if cells[cell] == "#"}


def centre(cell):
    """The middle of a cell in cm on the mat."""
    return (cell[0] + 0.5) * CELL, (cell[1] + 0.5) * CELL


def show(name, cells, colour, size=CELL):
    draw(name, [centre(cell) for cell in sorted(cells)], colour, "squares", size)


show("free", free, "#9ecae1")
show("occupied", occupied, "black")
frontier = find_frontier(free, occupied)
show("frontier", frontier, "gold")
print(len(frontier), "frontier cells")
