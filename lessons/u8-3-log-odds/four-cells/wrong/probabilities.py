# earns: those are probabilities
# Four cells
#
# The robot drives 50 cm towards a wall. Four cells are watched (the orange dots). Make
# the chart show the log odds of each of them at every look.

from bugbot import *
import math

L_OCC = 0.85  # the evidence of a hit
L_FREE = -0.4  # the evidence of each half-cell step of a pass
L_MAX = 8  # the clamp

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row
FAR = 170  # no wall is marked from a reading this long or longer [cm]
START = (100, 40)  # where the robot stands; position() counts from there
log_odds = [0.0] * (ACROSS * ACROSS)  # row after row, from the bottom

WATCHED = {
    "floor": (102.5, 122.5),
    "in front": (102.5, 147.5),
    "wall": (102.5, 152.5),
    "behind": (102.5, 177.5),
}


def cell_at(x, y):
    """Number of the cell that holds the point, or None beyond the mat."""
    column, row = math.floor(x / CELL), math.floor(y / CELL)
    if 0 <= column < ACROSS and 0 <= row < ACROSS:
        return row * ACROSS + column
    return None


def passed_and_hit(x, y, angle, reading):
    """What a beam says: a list of the cells it passed, and the cell it hit or None.

    A cell is in the list once for each half-cell step, so most cells are there twice.
    """
    dx, dy = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    clear = reading - CELL if reading < FAR else FAR  # stop one cell short of a hit
    steps = [i * CELL / 2 for i in range(int(clear / (CELL / 2)))]
    passed = [cell_at(x + along * dx, y + along * dy) for along in steps]
    hit = cell_at(x + reading * dx, y + reading * dy) if reading < FAR else None
    return [cell for cell in passed if cell is not None], hit


# ---- your part ----
def add(cell, evidence):
    """Add evidence to log_odds[cell], and keep it between -L_MAX and L_MAX."""
    log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + evidence))


def add_beam(x, y, angle, reading):
    """Add L_FREE for each passed cell in the list, and L_OCC for the cell that was hit."""
    passed, hit = passed_and_hit(x, y, angle, reading)
    for cell in passed:
        add(cell, L_FREE)
    if hit is not None:
        add(hit, L_OCC)


def watch():
    """Add a point to the chart for each watched cell: its name and its log odds."""
    for name, (x, y) in WATCHED.items():
        plot(name, 1 / (1 + math.exp(-log_odds[cell_at(x, y)])))


# ---- end of your part ----

draw("watched", list(WATCHED.values()), "orange", "dots", 3)
forward(50)
for tick in range(100):  # 10 seconds
    x, y = START[0] + position()[0], START[1] + position()[1]
    for angle, reading in scan():
        add_beam(x, y, heading() + angle, reading)
    watch()
    if position()[1] >= 50:
        stop()
    wait(0.1)
