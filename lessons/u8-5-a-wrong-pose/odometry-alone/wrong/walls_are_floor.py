# earns: not one cell is black
# A map from odometry() alone
#
# The hall at night: the camera sees nothing, so there
# is no position() and no heading(). The robot drives
# round its ring and keeps what it saw. Find out how fast
# the gyro drifts, and make the map without the drift.

from bugbot import *
import math

L_OCC = 0.85  # evidence of a hit
L_FREE = -0.4  # evidence of each step of a pass
L_MAX = 8  # the clamp
KNOWN = 1  # beyond this, either way, a cell is known

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row
FAR = 170  # a reading this long or longer is no wall [cm]
START = (72, 100)  # where it starts; odometry() counts from there


# ---- your part ----
def find_rate(looks):
    """How fast the believed heading drifts, in degrees/s."""
    rates = [i * 0.02 for i in range(-20, 21)]
    return min(rates, key=lambda rate: len(walls_of(corrected(looks, rate), looks)))


def corrected(looks, rate):
    """The poses of the looks without the drift: (x, y, facing)."""
    poses = []
    x, y = looks[0][1:3]
    before = looks[0]
    for look in looks:
        turned = math.radians(rate * look[0])
        dx, dy = look[1] - before[1], look[2] - before[2]
        x += dx * math.cos(turned) - dy * math.sin(turned)
        y += dy * math.cos(turned) + dx * math.sin(turned)
        poses.append((x, y, look[3] - rate * look[0]))
        before = look
    return poses


# ---- end of your part ----


# walls_of and the rest are for you to use.
def walls_of(poses, looks):
    """The cells in which beams ended, seen from these poses: a set."""
    cells = set()
    for (x, y, facing), look in zip(poses, looks):
        for angle, reading in look[4]:
            if reading < FAR:
                way = math.radians(facing + angle)
                column = math.floor((START[0] + x + reading * math.sin(way)) / CELL)
                row = math.floor((START[1] + y + reading * math.cos(way)) / CELL)
                cells.add((column, row))
    return cells


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


def show(poses, looks):
    """Draw the map of the looks, seen from these poses."""
    log_odds = [0.0] * (ACROSS * ACROSS)
    for (x, y, facing), look in zip(poses, looks):
        for angle, reading in look[4]:
            add_beam(log_odds, START[0] + x, START[1] + y, facing + angle, reading)
    log_odds = [-abs(each) for each in log_odds]
    cells = range(len(log_odds))
    free = [centre(cell) for cell in cells if log_odds[cell] < -KNOWN]
    occupied = [centre(cell) for cell in cells if log_odds[cell] > KNOWN]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)


looks = []  # time, x, y, heading as odometry has them, and the scan
drive(100, 0, 25)
for tick in range(320):  # 48 seconds, four times round the ring
    looks.append((clock(), *odometry(), scan()))
    wait(0.15)
stop()

rate = find_rate(looks)
print(f"drift: {rate:.2f} degrees/s")
poses = corrected(looks, rate)
draw("way", [(START[0] + x, START[1] + y) for x, y, facing in poses], "green", "line", 1)
show(poses, looks)
