# earns: the cell that was hit is not free
# A reading of nothing
#
# Fix beam_says, then press Run. The black
# bow across the bare mat should be gone.

from bugbot import *
import math

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row, and in a column
FAR = 170  # from here on no wall, in cm
START = (30, 30)  # where the robot starts on the mat


def beam_says(x, y, angle, reading):
    """The free cells, and the hit or None."""
    # ---- your part ----
    if reading < FAR:
        free = cells_along(x, y, angle, reading - CELL)
        hit = cell_of(*end_of_beam(x, y, angle, reading))
        free.append(hit)
    else:
        free = cells_along(x, y, angle, FAR)
        hit = None
    # ---- end of your part ----
    return free, hit


# These three are for you to use.
def end_of_beam(x, y, angle, length):
    """The point so many cm along a beam."""
    direction = math.radians(angle)
    return x + length * math.sin(direction), y + length * math.cos(direction)


def cell_of(x, y):
    """The (column, row) of a point, or None."""
    column = math.floor(x / CELL)
    row = math.floor(y / CELL)
    if 0 <= column < ACROSS and 0 <= row < ACROSS:
        return column, row
    return None


def cells_along(x, y, angle, length):
    """The cells at half-cell steps along a beam."""
    steps = [end_of_beam(x, y, angle, i * CELL / 2) for i in range(int(length / (CELL / 2)))]
    return [cell_of(*point) for point in steps if cell_of(*point) is not None]


# From here on the program only shows what beam_says does.
all_free, all_hit = set(), set()


def show(name, cells, colour):
    middles = [((column + 0.5) * CELL, (row + 0.5) * CELL) for column, row in sorted(cells)]
    draw(name, middles, colour, "squares", CELL)


turn(-45)  # to face straight up the mat
for look in range(7):
    for angle, reading in scan():
        free, hit = beam_says(*START, heading() + angle, reading)
        all_free.update(tuple(cell) for cell in free)
        if hit is not None:
            all_hit.add(tuple(hit))
    show("free", all_free, "#9ecae1")
    show("hit", all_hit, "black")
    wait(0.5)
    turn(15)
print("cells free:", len(all_free), "cells hit:", len(all_hit))
