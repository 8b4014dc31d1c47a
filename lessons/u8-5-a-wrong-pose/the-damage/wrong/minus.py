# earns: the drift has the wrong sign
# The damage
#
# The robot turns once on the spot and keeps all that it
# saw. What would the map be if its belief had drifted
# meanwhile? Make it for several drifts, and see how much
# of each is wrong.

from bugbot import *
import math

DRIFTS = [0, 0.5, 1, 2, 3]  # degrees a second

L_OCC = 0.85  # evidence of a hit
L_FREE = -0.4  # evidence of each step of a pass
L_MAX = 8  # the clamp
KNOWN = 1  # beyond this, either way, a cell is known

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row
FAR = 170  # a reading this long or longer is no wall [cm]
START = (72, 100)  # where it starts; odometry() counts from there

MAT = 200  # side of the mat [cm]
# What really stands in the hall: left, bottom, width, height.
REAL = [
    (88, 94, 12, 12),
    (130, 150, 50, 8),
    (20, 145, 30, 30),
    (150, 35, 8, 45),
    (40, 25, 50, 8),
]


# ---- your part ----
def drifted(looks, rate):
    """The looks with a heading that drifts by so many degrees/s.

    looks: (time, heading, readings); the drift begins at time 0
    Returns a new list; `looks` stays as it is.
    """
    return [(t, facing - rate * t, readings) for t, facing, readings in looks]


def experiment(looks):
    """Print, for each of DRIFTS, how much of the map is wrong."""
    for rate in DRIFTS:
        free, occupied = map_of(drifted(looks, rate))
        show(free, occupied)
        print(f"drift {rate}: {wrong_percent(occupied):.1f} % wrong")


# ---- end of your part ----


# map_of, wrong_percent and show are for you to use.
def add_beam(log_odds, x, y, angle, reading):
    """Add what one beam from (x, y) says to the flat list."""
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


def map_of(looks):
    """The map of looks from START: (free, occupied), middles of cells."""
    log_odds = [0.0] * (ACROSS * ACROSS)
    for t, facing, readings in looks:
        for angle, reading in readings:
            add_beam(log_odds, *START, facing + angle, reading)
    cells = range(len(log_odds))
    free = [centre(cell) for cell in cells if log_odds[cell] < -KNOWN]
    return free, [centre(cell) for cell in cells if log_odds[cell] > KNOWN]


def gap(x, y):
    """Distance to the nearest thing really there [cm]."""
    nearest = min(x, MAT - x, y, MAT - y)
    for left, bottom, width, height in REAL:
        dx = max(left - x, 0, x - (left + width))
        dy = max(bottom - y, 0, y - (bottom + height))
        nearest = min(nearest, math.hypot(dx, dy))
    return nearest


def wrong_percent(occupied):
    """Per cent of the black cells with nothing real near."""
    wrong = [point for point in occupied if gap(*point) > CELL]
    return 100 * len(wrong) / max(1, len(occupied))


def show(free, occupied):
    """Draw a map, and its wrong cells in red."""
    wrong = [point for point in occupied if gap(*point) > CELL]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)
    draw("wrong", wrong, "red", "dots", 3)


looks = []
right(30)  # 36 degrees a second
for tick in range(130):  # 13 seconds
    looks.append((clock(), heading(), scan()))
    wait(0.1)
stop()
experiment(looks)
