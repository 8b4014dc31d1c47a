# earns: cells has to stay as it was
# Regions
#
# Your function puts the frontier cells into groups that
# hang together. Each group gets a colour of its own.

from bugbot import *

CELL = 10  # cm per cell: large ones, to be seen easily
ACROSS = 20  # cells in a row
SIDES = [(-1, 0), (1, 0), (0, -1), (0, 1)]
CORNERS = [(-1, -1), (1, -1), (-1, 1), (1, 1)]

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
def find_regions(cells):
    """Groups of cells that hang together: a list of sets.

    cells: a set of cells (column, row). Two cells hang
    together if they share a side or a corner. Every cell
    is in exactly one group. cells itself is not changed.
    """
    left, regions = cells, []
    while left:
        region = [left.pop()]
        for column, row in region:  # the list grows while we walk along it
            new = {(column + c, row + r) for c, r in SIDES + CORNERS} & left
            region.extend(new)
            left -= new
        regions.append(set(region))
    return regions


# ---- end of your part ----


# The rest is done.
rows = MAP.split()[::-1]  # the lowest row first
cells = {(column, row): rows[row][column] for row in range(ACROSS) for column in range(ACROSS)}
free = {cell for cell in cells if cells[cell] == "."}
occupied = {cell for cell in cells if cells[cell] == "#"}
unknown = set(cells) - free - occupied
frontier = {
    (column, row) for column, row in free if any((column + c, row + r) in unknown for c, r in SIDES)
}


def centre(cell):
    """The middle of a cell in cm on the mat."""
    return (cell[0] + 0.5) * CELL, (cell[1] + 0.5) * CELL


def show(name, cells, colour, size=CELL):
    draw(name, [centre(cell) for cell in sorted(cells)], colour, "squares", size)


show("free", free, "#9ecae1")
show("occupied", occupied, "black")
regions = find_regions(frontier)
colours = ["gold", "red", "green", "purple", "orange", "brown", "pink", "navy"]
for number, region in enumerate(sorted(regions, key=min)):
    show(f"region {number}", region, colours[number % len(colours)])
print(len(regions), "regions, of", sorted(len(region) for region in regions), "cells")
