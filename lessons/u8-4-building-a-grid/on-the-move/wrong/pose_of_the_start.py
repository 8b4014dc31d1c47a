# earns: the pose is that of the start, not of now
# A map on the move
#
# This mapper works from one spot. Here the robot should drive once round a circle and
# map as it goes: 12 seconds at drive(100, 0, 25), with a look every tenth of a second.

from bugbot import *
import math

L_OCC = 0.85  # the evidence of a hit
L_FREE = -0.4  # the evidence of each half-cell step of a pass
L_MAX = 8  # the clamp
KNOWN = 1  # log odds beyond this, either way, count as known

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row
FAR = 170  # no wall is marked from a reading this long or longer [cm]
START = (72, 100)  # where the robot starts on the mat; position() counts from there
log_odds = [0.0] * (ACROSS * ACROSS)  # row after row, from the bottom


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


def show():
    """Draw the map in two layers, and plot how much of the mat is known."""
    cells = range(len(log_odds))
    middle = [((cell % ACROSS + 0.5) * CELL, (cell // ACROSS + 0.5) * CELL) for cell in cells]
    free = [middle[cell] for cell in cells if log_odds[cell] < -KNOWN]
    occupied = [middle[cell] for cell in cells if log_odds[cell] > KNOWN]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)
    plot("known %", 100 * (len(free) + len(occupied)) / len(log_odds))


# ---- your part ----
def look():
    """Take one scan, and add its beams to the map from where the robot is now."""
    x, y = START
    for angle, reading in scan():
        add_beam(x, y, angle, reading)


def drive_and_map():
    """Drive the circle, and look ten times a second on the way."""
    drive(100, 0, 25)
    for tick in range(120):  # 12 seconds
        look()
        if tick % 5 == 0:
            show()
        wait(0.1)
    stop()


# ---- end of your part ----

drive_and_map()
show()
