# earns: the gap to a cell's side
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
    k = int(SPARE / CELL) + 2
    near = [
        (c, r)
        for c in range(-k, k + 1)
        for r in range(-k, k + 1)
        if hypot(max(abs(c) - 0.5, 0), max(abs(r) - 0.5, 0)) * CELL < SPARE
    ]
    return {(x, y) for x, y in free if all((x + c, y + r) in free for c, r in near)}


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
