# earns: cell number 0, at the bottom left, was left out
# One beam into the grid
#
# The robot stands 110 cm from a wall and looks once.
# The lines show its eight beams. Your function adds
# what one beam says to the grid; the squares show the
# grid.

from bugbot import *
import math

L_OCC = 0.85  # evidence of a hit
L_FREE = -0.4  # evidence of each step of a pass
L_MAX = 8  # the clamp

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row
FAR = 170  # a reading this long or longer is no wall [cm]


# ---- your part ----
def number(px, py):
    c, r = math.floor(px / CELL), math.floor(py / CELL)
    if 0 <= c < ACROSS and 0 <= r < ACROSS:
        return r * ACROSS + c


def add_beam(log_odds, x, y, angle, reading):
    clear = reading - CELL if reading < FAR else FAR
    way = math.radians(angle)
    steps = []
    along = 0
    while along < clear:
        steps.append((along, L_FREE))
        along += CELL / 2
    if reading < FAR:
        steps.append((reading, L_OCC))
    for d, e in steps:
        cell = number(x + d * math.sin(way), y + d * math.cos(way))
        if cell:
            log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + e))


# ---- end of your part ----


# The rest is done.
def centre(cell):
    """The middle of a cell in cm on the mat."""
    return (cell % ACROSS + 0.5) * CELL, (cell // ACROSS + 0.5) * CELL


log_odds = [0.0] * (ACROSS * ACROSS)  # rows, from the bottom up
lines = []
for angle, reading in scan():
    way = math.radians(angle)
    lines += [(100, 40), (100 + reading * math.sin(way), 40 + reading * math.cos(way))]
    draw("beams", lines, "orange", "line", 0.5)
    add_beam(log_odds, 100, 40, angle, reading)
    cells = range(len(log_odds))
    free = [centre(cell) for cell in cells if log_odds[cell] < 0]
    hit = [centre(cell) for cell in cells if log_odds[cell] > 0]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", hit, "black", "squares", CELL)
    wait(0.5)
print(f"{len(free)} cells more likely free, {len(hit)} more likely occupied")
