# earns: int() cuts -0.4 down to 0
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
def add_beam(log_odds, x, y, angle, reading):
    """Add what one beam from (x, y) says to the flat list.

    Floor first: L_FREE at every half-cell step, up to one
    cell short of the hit, or up to FAR if there is no hit.
    Then L_OCC in the cell where the beam ended. The list
    itself is changed; nothing is returned.
    """
    dx = math.sin(math.radians(angle))
    dy = math.cos(math.radians(angle))
    step = CELL / 2
    clear = reading - CELL if reading < FAR else FAR
    evidence = [(i * step, L_FREE) for i in range(math.ceil(clear / step))]
    if reading < FAR:
        evidence.append((reading, L_OCC))
    for along, weight in evidence:
        column = int((x + along * dx) / CELL)
        row = int((y + along * dy) / CELL)
        if 0 <= column < ACROSS and 0 <= row < ACROSS:
            cell = row * ACROSS + column
            log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + weight))


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
