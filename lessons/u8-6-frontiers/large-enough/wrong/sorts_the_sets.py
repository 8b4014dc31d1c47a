# earns: sets have no order by size
# Large enough
#
# Most of the small regions are noise at a wall. Your
# function leaves them out, and puts the rest in order.

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
def large_regions(regions, at_least):
    large = [region for region in regions if len(region) >= at_least]
    return sorted(large, reverse=True)


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


def find_regions(cells):
    left, regions = set(cells), []
    while left:
        region = [left.pop()]
        for column, row in region:
            new = {(column + c, row + r) for c, r in SIDES + CORNERS} & left
            region.extend(new)
            left -= new
        regions.append(set(region))
    return regions


regions = find_regions(frontier)
large = large_regions(regions, 4)
show("small regions", frontier, "gold", CELL / 2)
for number, region in enumerate(large):
    show(f"region {number}", region, "gold")
print(len(large), "of", len(regions), "regions are large enough")
