# earns: column and row go up to ACROSS - 1
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
    clear = reading - CELL if reading < FAR else FAR
    way = math.radians(angle)

    def add(d, e):
        c = math.floor((x + d * math.sin(way)) / CELL)
        r = math.floor((y + d * math.cos(way)) / CELL)
        if 0 <= c < ACROSS - 1 and 0 <= r < ACROSS - 1:
            i = r * ACROSS + c
            log_odds[i] = max(-L_MAX, min(L_MAX, log_odds[i] + e))

    along = 0
    while along < clear:
        add(along, L_FREE)
        along += CELL / 2
    if reading < FAR:
        add(reading, L_OCC)


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
