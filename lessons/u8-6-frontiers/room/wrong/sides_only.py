# earns: a cell at a corner is 7.1 cm away
# Room for the robot
#
# The robot is a disc of 5 cm, and the map has cells. On
# which cells does it have room? Your function finds
# them: green squares. There should be a green path
# through the doorway.

from bugbot import *
from math import hypot

SPARE = 6  # cm from the robot's middle to anything solid, at least
CELL = 5  # cm per cell
ACROSS = 40  # cells in a row


# ---- your part ----
def find_room(free):
    """The free cells on whose middle the robot has room.

    free: a set of cells (column, row). A cell has room if
    every cell that is not free is at least
    SPARE + CELL / 2 away, from middle to middle. Cells
    beyond the mat are not free either.
    """
    far = SPARE + CELL / 2
    reach = range(-int(far / CELL), int(far / CELL) + 1)
    near = [(c, r) for c in reach for r in reach if abs(c) + abs(r) < 2]
    return {
        (column, row) for column, row in free if all((column + c, row + r) in free for c, r in near)
    }


# ---- end of your part ----


# The rest is done.
solid = {(column, row) for column in range(40) for row in (24, 25) if not 18 <= column < 22}
solid |= {(column, row) for column in range(26, 30) for row in range(6, 10)}
free = {(column, row) for column in range(40) for row in range(38)} - solid


def show(name, cells, colour, size=CELL):
    middles = [((column + 0.5) * CELL, (row + 0.5) * CELL) for column, row in sorted(cells)]
    draw(name, middles, colour, "squares", size)


room = find_room(free)
show("free", free, "#9ecae1")
show("solid", solid, "black")
show("room", room, "green", CELL / 2)
print(len(room), "of", len(free), "free cells have room")
