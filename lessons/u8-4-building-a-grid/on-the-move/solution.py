# A map on the move
#
# This mapper works from one spot. Here the robot should
# drive once round a circle and map as it goes: 12
# seconds at drive(100, 0, 25), with a look every tenth
# of a second.

from bugbot import *
import math

L_OCC = 0.85  # evidence of a hit
L_FREE = -0.4  # evidence of each step of a pass
L_MAX = 8  # the clamp
KNOWN = 1  # beyond this, either way, a cell is known

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row
FAR = 170  # a reading this long or longer is no wall [cm]
START = (72, 100)  # where it starts; position() counts from there
log_odds = [0.0] * (ACROSS * ACROSS)  # rows, from the bottom up


# ---- your part ----
def look():
    """Add one scan to the map, from where the robot is now."""
    x, y = START[0] + position()[0], START[1] + position()[1]
    for angle, reading in scan():
        add_beam(x, y, heading() + angle, reading)


def drive_and_map():
    """Drive the circle, and look ten times a second."""
    drive(100, 0, 25)
    for tick in range(120):  # 12 seconds
        look()
        if tick % 5 == 0:
            show()
        wait(0.1)
    stop()


# ---- end of your part ----


# add_beam and show are for you to use.
def add_beam(x, y, angle, reading):
    """Add what one beam says to log_odds."""
    dx = math.sin(math.radians(angle))
    dy = math.cos(math.radians(angle))
    step = CELL / 2
    clear = reading - CELL if reading < FAR else FAR
    evidence = [(i * step, L_FREE) for i in range(int(clear / step))]
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


def show():
    """Draw the map, and plot how much of it is known."""
    cells = range(len(log_odds))
    free = [centre(cell) for cell in cells if log_odds[cell] < -KNOWN]
    occupied = [centre(cell) for cell in cells if log_odds[cell] > KNOWN]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)
    plot("known %", 100 * (len(free) + len(occupied)) / len(log_odds))


drive_and_map()
show()
