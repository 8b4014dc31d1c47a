# earns: a cell with log odds of 0 was left out
# Three states
#
# The robot turns once and maps. Your function sorts the
# cells: free, occupied, or neither. Light blue squares
# show the free ones, black squares the occupied ones.

from bugbot import *
import math

OCC_P = 0.65  # a cell is occupied when its probability is above this
FREE_P = 0.35  # and free when it is below this

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row
FAR = 170  # a reading this long or longer is no wall [cm]
START = (100, 100)  # where the robot stands
L_OCC, L_FREE, L_MAX = 0.85, -0.4, 8


# ---- your part ----
def read_map(log_odds):
    free, occupied = set(), set()
    for cell, l in log_odds.items():
        if l == 0:
            continue
        p = 1 / (1 + math.exp(-l))
        if p > OCC_P:
            occupied.add(cell)
        if p < FREE_P:
            free.add(cell)
    return free, occupied


# ---- end of your part ----


# The rest is done.
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


def show(name, cells, colour):
    middles = [((column + 0.5) * CELL, (row + 0.5) * CELL) for column, row in sorted(cells)]
    draw(name, middles, colour, "squares", CELL)


right(60)
for tick in range(50):
    for angle, reading in scan():
        add_beam(*START, heading() + angle, reading)
    wait(0.1)
stop()
free, occupied = read_map(log_odds)
show("free", free, "#9ecae1")
show("occupied", occupied, "black")
print(f"{len(free)} free, {len(occupied)} occupied, ", end="")
print(f"{len(log_odds) - len(free) - len(occupied)} unknown")
