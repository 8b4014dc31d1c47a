# earns: min() and max() have changed places
# Four cells
#
# The robot drives 50 cm towards a wall. Four cells are
# watched (the orange dots). Make the chart show the log
# odds of each of them at every look.

from bugbot import *
import math

L_OCC = 0.85  # evidence of a hit
L_FREE = -0.4  # evidence of each step of a pass
L_MAX = 8  # the clamp

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row
FAR = 170  # a reading this long or longer is no wall [cm]
START = (100, 40)  # where it starts; position() counts from there
log_odds = [0.0] * (ACROSS * ACROSS)  # rows, from the bottom up

WATCHED = {
    "floor": (102.5, 122.5),
    "in front": (102.5, 147.5),
    "wall": (102.5, 152.5),
    "behind": (102.5, 177.5),
}


# ---- your part ----
def add(cell, evidence):
    """Add evidence to log_odds[cell], and clamp it."""
    log_odds[cell] = min(-L_MAX, max(L_MAX, log_odds[cell] + evidence))


def add_beam(x, y, angle, reading):
    """Add L_FREE for each passed cell, L_OCC for the hit."""
    passed, hit = passed_and_hit(x, y, angle, reading)
    for cell in passed:
        add(cell, L_FREE)
    if hit is not None:
        add(hit, L_OCC)


def watch():
    """Plot the log odds of each watched cell."""
    for name, (x, y) in WATCHED.items():
        plot(name, log_odds[cell_at(x, y)])


# ---- end of your part ----


# passed_and_hit and cell_at are for you to use.
def cell_at(x, y):
    """Number of the cell of a point; None beyond the mat."""
    column, row = math.floor(x / CELL), math.floor(y / CELL)
    if 0 <= column < ACROSS and 0 <= row < ACROSS:
        return row * ACROSS + column
    return None


def passed_and_hit(x, y, angle, reading):
    """The cells a beam passed, and the cell it hit or None.

    A passed cell is in the list once for each half-cell
    step, so most of them are there twice.
    """
    way = math.radians(angle)
    dx, dy = math.sin(way), math.cos(way)
    clear = reading - CELL if reading < FAR else FAR
    steps = [i * CELL / 2 for i in range(int(clear / (CELL / 2)))]
    passed = [cell_at(x + along * dx, y + along * dy) for along in steps]
    hit = cell_at(x + reading * dx, y + reading * dy) if reading < FAR else None
    return [cell for cell in passed if cell is not None], hit


def centre(cell):
    """The middle of a cell in cm on the mat."""
    return (cell % ACROSS + 0.5) * CELL, (cell // ACROSS + 0.5) * CELL


def show():
    """Draw the map, and the watched cells over it."""
    cells = range(len(log_odds))
    free = [centre(cell) for cell in cells if log_odds[cell] < -1]
    occupied = [centre(cell) for cell in cells if log_odds[cell] > 1]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)
    draw("watched", list(WATCHED.values()), "orange", "dots", 3)


forward(50)
for tick in range(100):  # 10 seconds
    x, y = START[0] + position()[0], START[1] + position()[1]
    for angle, reading in scan():
        add_beam(x, y, heading() + angle, reading)
    watch()
    if tick % 5 == 0:
        show()
    if position()[1] >= 50:
        stop()
    wait(0.1)
show()
