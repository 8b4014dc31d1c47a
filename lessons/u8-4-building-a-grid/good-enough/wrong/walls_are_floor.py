# earns: not one cell is black
# A map good enough
#
# A cross of floor is clear in every room: along x = 100
# and along y = 100, from 25 to 175. Drive where you
# like on it. Wanted at the end, within 75 seconds: at
# least 85 % of the mat known, and at most 5 % of the
# black cells wrong.

from bugbot import *
import math

L_OCC = 0.85  # evidence of a hit
L_FREE = -0.4  # evidence of each step of a pass
L_MAX = 8  # the clamp
KNOWN = 1  # beyond this, either way, a cell is known

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row
FAR = 170  # a reading this long or longer is no wall [cm]
START = (100, 25)  # where it starts; position() counts from there
log_odds = [0.0] * (ACROSS * ACROSS)  # rows, from the bottom up


# ---- your part ----
def look_round():
    """Turn once on the spot, and map meanwhile."""
    right(60)
    keep_mapping(5)


def drive_to(x, y):
    """Face a point of the mat, and drive straight there; map on the way."""
    dx, dy = x - START[0] - position()[0], y - START[1] - position()[1]
    turn((math.degrees(math.atan2(dx, dy)) - heading() + 180) % 360 - 180, speed=100)
    forward(100)
    keep_mapping(math.hypot(dx, dy) / 11.5)  # 100 per cent is 11.5 cm/s


def explore():
    """The whole route."""
    for x, y in [(100, 100), (30, 100), (170, 100), (100, 100), (100, 170)]:
        drive_to(x, y)
        look_round()


# ---- end of your part ----


# keep_mapping and the rest are for you to use.
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


def look():
    """Add one scan to the map, from where the robot is now."""
    x, y = START[0] + position()[0], START[1] + position()[1]
    for angle, reading in scan():
        add_beam(x, y, heading() + angle, reading)


def centre(cell):
    """The middle of a cell in cm on the mat."""
    return (cell % ACROSS + 0.5) * CELL, (cell // ACROSS + 0.5) * CELL


def show():
    """Draw the map, and plot how much of it is known."""
    cells = range(len(log_odds))
    free = [centre(cell) for cell in cells if log_odds[cell] < -KNOWN]
    occupied = [centre(cell) for cell in cells if log_odds[cell] > KNOWN]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)
    plot("known %", 100 * (len(free) + len(occupied)) / len(log_odds))


def keep_mapping(seconds):
    """Let the robot go on for some seconds, and map."""
    for tick in range(round(seconds * 10)):
        look()
        if tick % 5 == 0:
            show()
        wait(0.1)
    stop()
    show()


explore()
for cell in range(len(log_odds)):
    log_odds[cell] = -abs(log_odds[cell])
show()
