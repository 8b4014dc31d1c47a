# Turn and look
#
# A whole mapper. The robot turns round on the spot. How
# fast it turns and how often it looks decide how many
# beams each cell gets.

from bugbot import *
import math

# Numbers to change
TURN = 30  # how fast to turn, per cent (5 to 100)
LOOKS = 10  # looks a second (1 to 20)
ROUNDS = 1  # how often to turn right round (1 to 4)
L_OCC = 0.85  # evidence of a hit (0 to 2)
L_FREE = -0.4  # evidence of each step of a pass (-1 to 0)
FAR = 170  # a reading this long is no wall, cm (50 to 300)
KNOWN = 1  # beyond this, either way, a cell is known (0.1 to 5)

L_MAX = 8  # the clamp
CELL = 5  # cm per cell
ACROSS = 40  # cells in a row
START = (45, 30)  # where the robot stands on the mat

# What really stands there, to count the map's mistakes:
# left, bottom, width, height.
REAL = [(100, 40, 8, 50), (50, 120, 50, 8), (150, 120, 30, 8)]
log_odds = [0.0] * (ACROSS * ACROSS)


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


def gap_to_real(x, y):
    """Distance to the nearest thing really there [cm]."""
    gap = min(x, 200 - x, y, 200 - y)  # the walls round the mat
    for left, bottom, width, height in REAL:
        dx = max(left - x, 0, x - (left + width))
        dy = max(bottom - y, 0, y - (bottom + height))
        gap = min(gap, math.hypot(dx, dy))
    return gap


def centre(cell):
    """The middle of a cell in cm on the mat."""
    return (cell % ACROSS + 0.5) * CELL, (cell // ACROSS + 0.5) * CELL


def show():
    """Draw the map; plot how much is known, how much wrong."""
    cells = range(len(log_odds))
    free = [centre(cell) for cell in cells if log_odds[cell] < -KNOWN]
    occupied = [centre(cell) for cell in cells if log_odds[cell] > KNOWN]
    wrong = [point for point in occupied if gap_to_real(*point) > CELL]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)
    draw("wrong", wrong, "red", "dots", 3)
    plot("known %", 100 * (len(free) + len(occupied)) / len(log_odds))
    plot("wrong walls %", 100 * len(wrong) / max(1, len(occupied)))


right(TURN)
for tick in range(round(ROUNDS * LOOKS * 360 / (1.2 * TURN))):
    for angle, reading in scan():
        add_beam(START[0], START[1], heading() + angle, reading)
    if tick % 5 == 0:
        show()
    wait(1 / LOOKS)
stop()
show()
