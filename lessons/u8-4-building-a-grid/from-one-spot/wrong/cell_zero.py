# earns: cell number 0, at the bottom left, was left out
# A map from one spot
#
# The robot turns on the spot in a corner of the mat.
# Write the whole mapper. Most of it you have written
# already: bring it here from the tasks before.

from bugbot import *
import math

L_OCC = 0.85  # evidence of a hit
L_FREE = -0.4  # evidence of each step of a pass
L_MAX = 8  # the clamp
KNOWN = 1  # beyond this, either way, a cell is known

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row
FAR = 170  # a reading this long or longer is no wall [cm]
START = (45, 30)  # where it starts; position() counts from there
log_odds = [0.0] * (ACROSS * ACROSS)  # rows, from the bottom up


# ---- your part ----
def add_beam(x, y, angle, reading):
    """Add what one beam says to log_odds."""
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
            if not cell:
                continue
            log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + weight))


def look():
    """Add one scan to the map, from where the robot is now."""
    x, y = START[0] + position()[0], START[1] + position()[1]
    for angle, reading in scan():
        add_beam(x, y, heading() + angle, reading)


def show():
    """Draw the map, and plot how much of it is known."""
    cells = range(len(log_odds))
    free = [centre(cell) for cell in cells if log_odds[cell] < -KNOWN]
    occupied = [centre(cell) for cell in cells if log_odds[cell] > KNOWN]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)
    plot("known %", 100 * (len(free) + len(occupied)) / len(log_odds))


# ---- end of your part ----


# centre is for you to use.
def centre(cell):
    """The middle of a cell in cm on the mat."""
    return (cell % ACROSS + 0.5) * CELL, (cell // ACROSS + 0.5) * CELL


right(30)  # 36 degrees a second
for tick in range(130):  # 13 seconds
    look()
    if tick % 5 == 0:
        show()
    wait(0.1)
stop()
show()
