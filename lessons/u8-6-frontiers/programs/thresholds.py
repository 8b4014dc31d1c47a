# Thresholds
#
# One map from one spot, and two thresholds that sort its
# cells. The map is made once, then sorted: light blue is
# free, black is occupied, bare is unknown.

from bugbot import *
import math

# Numbers to change
OCC_P = 0.65  # a cell is occupied when its probability is above this (0.5 to 0.9999)
FREE_P = 0.35  # and free when it is below this (0.0001 to 0.5)

CELL, ACROSS, FAR, START = 5, 40, 170, (100, 100)
L_OCC, L_FREE, L_MAX = 0.85, -0.4, 8
log_odds = {(column, row): 0.0 for row in range(ACROSS) for column in range(ACROSS)}


def add_beam(x, y, angle, reading):
    """Add what one beam says to log_odds."""
    dx, dy = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    clear = reading - CELL if reading < FAR else FAR
    evidence = [(i * CELL / 2, L_FREE) for i in range(int(clear / (CELL / 2)))]
    if reading < FAR:
        evidence.append((reading, L_OCC))
    for along, weight in evidence:
        cell = math.floor((x + along * dx) / CELL), math.floor((y + along * dy) / CELL)
        if cell in log_odds:
            log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + weight))


def probability(l):
    return 1 / (1 + math.exp(-l))


def show(name, cells, colour):
    middles = [((column + 0.5) * CELL, (row + 0.5) * CELL) for column, row in cells]
    draw(name, middles, colour, "squares", CELL)


right(60)
for tick in range(50):
    for angle, reading in scan():
        add_beam(*START, heading() + angle, reading)
    wait(0.1)
stop()
free = [cell for cell, l in log_odds.items() if probability(l) < FREE_P]
occupied = [cell for cell, l in log_odds.items() if probability(l) > OCC_P]
show("free", free, "#9ecae1")
show("occupied", occupied, "black")
print("free:", len(free))
print("occupied:", len(occupied))
print("unknown:", len(log_odds) - len(free) - len(occupied))
