# The small maze: a map along a route
#
# A person has chosen the route: through every corridor, into the dead end at the
# bottom right and out again. At each corner the robot looks all round.

from bugbot import *
import math

# Numbers to change
CELL = 5  # cm per cell (5 to 20)
L_OCC = 0.85  # added to the cell a beam ended in (0 to 2)
L_FREE = -0.4  # added at each half-cell step a beam passed (-1 to 0)
L_MAX = 8  # log odds stay between -L_MAX and L_MAX (1 to 100)
KNOWN = 1  # log odds beyond this, either way, count as known (0.5 to 5)
SPEED = 100  # driving speed, per cent (40 to 100)

# The mat
MAT = 200  # side of the mat [cm]
FAR = 170  # no wall is marked from a reading this long or longer [cm]
START = (22, 22)  # where the robot stands; position() counts from there
ACROSS = math.ceil(MAT / CELL)
log_odds = [0.0] * (ACROSS * ACROSS)  # row after row, from the bottom; 0 is unknown

ROUTE = [
    (22, 126),
    (74, 126),
    (74, 22),
    (178, 22),
    (74, 22),
    (74, 126),
    (126, 126),
    (126, 74),
    (178, 74),
    (178, 178),
    (22, 178),
]


def add_beam(x, y, angle, reading):
    """Add what one beam says: free floor all the way, and a hit where it ended."""
    dx = math.sin(math.radians(angle))  # angles are clockwise from up the mat,
    dy = math.cos(math.radians(angle))  # so x goes by sine and y by cosine
    step = CELL / 2
    clear = reading - CELL if reading < FAR else FAR  # stop one cell short of a hit
    evidence = [(i * step, L_FREE) for i in range(int(clear / step))]
    if reading < FAR:
        evidence.append((reading, L_OCC))
    for along, weight in evidence:
        column = math.floor((x + along * dx) / CELL)
        row = math.floor((y + along * dy) / CELL)
        if 0 <= column < ACROSS and 0 <= row < ACROSS:  # beyond the mat is no cell
            cell = row * ACROSS + column
            log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + weight))


def where():
    """The robot's place on the mat [cm]."""
    return START[0] + position()[0], START[1] + position()[1]


def keep_mapping(seconds):
    """Go on with what the robot is doing, and look ten times a second."""
    for tick in range(round(seconds * 10)):
        (x, y), facing = where(), heading()
        for angle, reading in scan():
            add_beam(x, y, facing + angle, reading)
        if tick % 10 == 0:
            show()
        wait(0.1)
    stop()


def centre(cell):
    """The middle of a cell in cm on the mat."""
    return (cell % ACROSS + 0.5) * CELL, (cell // ACROSS + 0.5) * CELL


def show():
    """Draw the map and add a point to the chart."""
    cells = range(len(log_odds))
    free = [centre(cell) for cell in cells if log_odds[cell] < -KNOWN]
    occupied = [centre(cell) for cell in cells if log_odds[cell] > KNOWN]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)
    plot("known %", 100 * (len(free) + len(occupied)) / len(log_odds))


def drive_to(goal):
    """Face the goal, then drive straight there and map on the way."""
    x, y = where()
    bearing = math.degrees(math.atan2(goal[0] - x, goal[1] - y))
    turn((bearing - heading() + 180) % 360 - 180, speed=50)  # the shorter way round
    forward(SPEED)
    keep_mapping(math.dist((x, y), goal) / (0.115 * SPEED))  # 100 per cent is 11.5 cm/s


def look_round():
    """Turn once on the spot and map all round."""
    right(50)
    keep_mapping(6)  # 60 degrees a second


draw("route", [START, *ROUTE], "green", "line", 0.5)
look_round()
for goal in ROUTE:
    drive_to(goal)
    look_round()
show()
