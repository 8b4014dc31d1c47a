# One beam
#
# The robot turns by ANGLE and takes one
# reading straight ahead. The floor that the
# beam passed over is blue, the cell where it
# ended is black.

from bugbot import *
import math

# Numbers to change
ANGLE = 0  # degrees clockwise (-180 to 180)
CELL = 5  # cm per cell (2 to 20)

START = (100, 40)  # where the robot stands


def cell_of(x, y):
    """The column and the row of the cell that holds a point."""
    return math.floor(x / CELL), math.floor(y / CELL)


def end_of_beam(x, y, angle, reading):
    """The point that lies so far away in this direction."""
    direction = math.radians(angle)
    return x + reading * math.sin(direction), y + reading * math.cos(direction)


def middles(cells):
    return [((column + 0.5) * CELL, (row + 0.5) * CELL) for column, row in cells]


turn(ANGLE)
wait(0.5)  # let the robot come to rest
reading = distance()

free = []
along = 0
while along < reading - CELL:  # stop one cell short of the hit
    cell = cell_of(*end_of_beam(*START, ANGLE, along))
    if cell not in free:
        free.append(cell)
    along += CELL / 2  # half a cell on
hit = cell_of(*end_of_beam(*START, ANGLE, reading))

draw("free", middles(free), "#9ecae1", "squares", CELL)
draw("hit", middles([hit]), "black", "squares", CELL)
draw("beam", [START, end_of_beam(*START, ANGLE, reading)], "red", "line", 0.7)
print("reading:", round(reading, 1), "cm")
print("cells that it passed:", len(free))
print("cell that it hit: column", hit[0], "row", hit[1])
