# earns: the last beam is missing
# One scan into the grid
#
# The robot faces half right and looks once. A scan is a
# list of eight pairs: an angle from straight ahead, and
# a reading. Add all eight beams to the grid.

from bugbot import *
import math

L_OCC = 0.85  # evidence of a hit
L_FREE = -0.4  # evidence of each step of a pass
L_MAX = 8  # the clamp

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row
FAR = 170  # a reading this long or longer is no wall [cm]


# ---- your part ----
def add_scan(log_odds, x, y, facing, readings):
    """Add a complete scan, taken at (x, y), to the flat list.

    readings: pairs (angle from straight ahead, distance)
    The list itself is changed; nothing is returned.
    """
    for i in range(len(readings) - 1):
        angle, reading = readings[i]
        add_beam(log_odds, x, y, facing + angle, reading)


# ---- end of your part ----


# add_beam is for you to use.
def add_beam(log_odds, x, y, angle, reading):
    """Add what one beam from (x, y) says to the flat list."""
    dx = math.sin(math.radians(angle))
    dy = math.cos(math.radians(angle))
    step = CELL / 2
    clear = reading - CELL if reading < FAR else FAR
    evidence = [(i * step, L_FREE) for i in range(math.ceil(clear / step))]
    if reading < FAR:
        evidence.append((reading, L_OCC))
    for along, weight in evidence:
        column = math.floor((x + along * dx) / CELL)
        row = math.floor((y + along * dy) / CELL)
        if 0 <= column < ACROSS and 0 <= row < ACROSS:
            cell = row * ACROSS + column
            log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + weight))


def centre(cell):
    """The middle of a cell in cm on the mat."""
    return (cell % ACROSS + 0.5) * CELL, (cell // ACROSS + 0.5) * CELL


log_odds = [0.0] * (ACROSS * ACROSS)
turn(45)
for look in range(10):
    add_scan(log_odds, 100, 100, heading(), scan())
    cells = range(len(log_odds))
    free = [centre(cell) for cell in cells if log_odds[cell] < -1]
    hit = [centre(cell) for cell in cells if log_odds[cell] > 1]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", hit, "black", "squares", CELL)
    plot("free cells", len(free))
    plot("occupied cells", len(hit))
    wait(0.1)
