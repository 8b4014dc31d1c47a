# One turn with a drift
#
# The robot turns once on the spot. Its belief drifts by
# as much as you like. Red dots are black cells with
# nothing real near.

from bugbot import *
import math

# Numbers to change
DRIFT = 2  # how fast the believed heading drifts, degrees a second (-5 to 5)
SECONDS = 13  # how long it turns (1 to 40)

L_OCC, L_FREE, L_MAX, KNOWN = 0.85, -0.4, 8, 1
CELL, ACROSS, FAR, START = 5, 40, 170, (72, 100)
# What really stands in the hall: left, bottom, width, height. The
# maps never look at this; it is here to count their mistakes.
REAL = [
    (88, 94, 12, 12),
    (130, 150, 50, 8),
    (20, 145, 30, 30),
    (150, 35, 8, 45),
    (40, 25, 50, 8),
]
log_odds = [0.0] * (ACROSS * ACROSS)


def add_beam(x, y, angle, reading):
    """Add what one beam from (x, y) says to the map."""
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


def gap(x, y):
    """Distance to the nearest thing really there [cm]."""
    nearest = min(x, 200 - x, y, 200 - y)
    for left, bottom, width, height in REAL:
        dx = max(left - x, 0, x - (left + width))
        dy = max(bottom - y, 0, y - (bottom + height))
        nearest = min(nearest, math.hypot(dx, dy))
    return nearest


def show():
    """Draw the map, and plot how much of it is known and wrong."""
    cells = range(len(log_odds))
    free = [centre(cell) for cell in cells if log_odds[cell] < -KNOWN]
    occupied = [centre(cell) for cell in cells if log_odds[cell] > KNOWN]
    wrong = [point for point in occupied if gap(*point) > CELL]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)
    draw("wrong", wrong, "red", "dots", 3)
    plot("known %", 100 * (len(free) + len(occupied)) / len(log_odds))
    plot("wrong walls %", 100 * len(wrong) / max(1, len(occupied)))


right(30)  # 36 degrees a second
for tick in range(SECONDS * 10):
    believed = heading() + DRIFT * clock()
    for angle, reading in scan():
        add_beam(*START, believed + angle, reading)
    if tick % 5 == 0:
        show()
    wait(0.1)
stop()
show()
