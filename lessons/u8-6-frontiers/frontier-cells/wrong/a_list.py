# earns: it is a list; the task asks for a set
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
    found = []
    for c, r in free:
        for i, j in SIDES:
            n = c + i, r + j
            inside = 0 <= n[0] < ACROSS and 0 <= n[1] < ACROSS
            if inside and n not in free and n not in occupied and (c, r) not in found:
                found.append((c, r))
    return found


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
