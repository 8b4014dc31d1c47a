# Demo 1: a map from one spot
#
# The robot turns on the spot. Ten times a second it
# looks with its depth sensor and adds what it saw to a
# grid: one number, the log odds, per cell.

from bugbot import *
import math

# Numbers to change
CELL = 5  # cm per cell (5 to 20)
L_OCC = 0.85  # added to the cell a beam ended in (0 to 3)
L_FREE = -0.4  # added at each half-cell step a beam passed (-1 to 0)
L_MAX = 8  # log odds stay between -L_MAX and L_MAX (1 to 100)
KNOWN = 1  # log odds beyond this, either way, count as known (0.5 to 5)
SECONDS = 13  # how long the robot turns (1 to 30)

# The mat
MAT = 200  # side of the mat [cm]
FAR = 170  # no wall is marked from a reading this long or longer [cm]
START = (100, 100)  # where the robot stands; position() counts from there
ACROSS = math.ceil(MAT / CELL)
log_odds = [0.0] * (ACROSS * ACROSS)  # row after row, from the bottom; 0 is unknown

# What really stands there: (left, bottom, width, height) of each thing. The
# map never looks at this; it is here to count the map's mistakes.
REAL = [(130, 70, 8, 70), (40, 150, 70, 8)]


def add_beam(x, y, angle, reading):
    """Add what one beam says: free floor all the way, and a hit where it ended."""
    dx = math.sin(math.radians(angle))  # angles are clockwise from up the mat,
    dy = math.cos(math.radians(angle))  # so x goes by sine and y by cosine
    step = CELL / 2
    clear = reading - CELL if reading < FAR else FAR  # stop one cell short of a hit
    evidence = [(i * step, L_FREE) for i in range(int(clear / step))]
    if reading < FAR:
        evidence.append((reading, L_OCC))
    for along, weight in evidence:
        column = math.floor((x + along * dx) / CELL)
        row = math.floor((y + along * dy) / CELL)
        if 0 <= column < ACROSS and 0 <= row < ACROSS:  # beyond the mat is no cell
            cell = row * ACROSS + column
            log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + weight))


def look():
    """Add one scan, 8 beams, from where the robot is."""
    x = START[0] + position()[0]
    y = START[1] + position()[1]
    facing = heading()
    for angle, reading in scan():
        add_beam(x, y, facing + angle, reading)


def centre(cell):
    """The middle of a cell in cm on the mat."""
    return (cell % ACROSS + 0.5) * CELL, (cell // ACROSS + 0.5) * CELL


def gap_to_real(x, y):
    """How far a point is from the nearest thing really there [cm]."""
    gap = min(x, MAT - x, y, MAT - y)  # the walls round the mat
    for left, bottom, width, height in REAL:
        dx = max(left - x, 0, x - (left + width))
        dy = max(bottom - y, 0, y - (bottom + height))
        gap = min(gap, math.hypot(dx, dy))
    return gap


def show():
    """Draw the map and add a point to each line of the chart."""
    cells = range(len(log_odds))
    free = [centre(cell) for cell in cells if log_odds[cell] < -KNOWN]
    occupied = [centre(cell) for cell in cells if log_odds[cell] > KNOWN]
    wrong = [point for point in occupied if gap_to_real(*point) > CELL]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)
    plot("known %", 100 * (len(free) + len(occupied)) / len(log_odds))
    plot("wrong walls %", 100 * len(wrong) / max(1, len(occupied)))


right(30)  # turn clockwise at 30 per cent: 36 degrees a second
for tick in range(SECONDS * 10):
    look()
    if tick % 5 == 0:
        show()
    wait(0.1)
stop()
show()
