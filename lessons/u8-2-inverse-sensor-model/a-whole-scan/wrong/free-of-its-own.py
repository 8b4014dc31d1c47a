# earns: look() makes a new set free
# A whole scan
#
# Let look use the whole scan, then press Run.
# The room should appear.

from bugbot import *
import math

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row, and in a column
FAR = 170  # from here on no wall, in cm
START = (100, 100)  # position() counts from here

free = set()  # every cell that any beam passed
hits = set()  # every cell where any beam ended


def look():
    """Add what the robot sees from here."""
    free = set()
    x = START[0] + position()[0]
    y = START[1] + position()[1]
    for angle, reading in scan():
        passed, hit = beam_says(x, y, heading() + angle, reading)
        free |= passed
        if hit is not None:
            hits.add(hit)


# beam_says is for you to use; the rest is done.
def cell_at(x, y, angle, length):
    """The cell so far along a beam, or None."""
    direction = math.radians(angle)
    column = math.floor((x + length * math.sin(direction)) / CELL)
    row = math.floor((y + length * math.cos(direction)) / CELL)
    if 0 <= column < ACROSS and 0 <= row < ACROSS:
        return column, row
    return None


def beam_says(x, y, angle, reading):
    """The free cells, and the hit or None."""
    clear = reading - CELL if reading < FAR else FAR
    passed = {cell_at(x, y, angle, i * CELL / 2) for i in range(int(clear / (CELL / 2)))}
    hit = cell_at(x, y, angle, reading) if reading < FAR else None
    return passed - {None}, hit


def show():
    """Draw the cells; a hit goes before free."""
    for name, cells, colour in [("free", free - hits, "#9ecae1"), ("hit", hits, "black")]:
        middles = [((column + 0.5) * CELL, (row + 0.5) * CELL) for column, row in sorted(cells)]
        draw(name, middles, colour, "squares", CELL)


def look_round():
    """Look in nine directions, 40 degrees apart."""
    for direction in range(9):
        look()
        show()
        turn(40, speed=50)


look_round()
forward(80, distance=30)
look_round()
print("cells free:", len(free - hits), "cells hit:", len(hits))
