# The empty mat: a map from a moving robot
#
# The robot drives in a circle and maps as it goes. Nothing hides anything here,
# so one round shows it the whole mat, but for the spot it drove round.

from bugbot import *
import math

# Numbers to change
CELL = 5  # cm per cell (5 to 20)
L_OCC = 0.85  # added to the cell a beam ended in (0 to 2)
L_FREE = -0.4  # added at each half-cell step a beam passed (-1 to 0)
L_MAX = 8  # log odds stay between -L_MAX and L_MAX (1 to 100)
KNOWN = 1  # log odds beyond this, either way, count as known (0.5 to 5)
SPEED = 60  # driving speed, per cent (0 to 100)
TURN = 20  # turning speed, per cent (15 to 100)

# The mat
MAT = 200  # side of the mat [cm]
FAR = 170  # no wall is marked from a reading this long or longer [cm]
START = (100, 100)  # where the robot stands; position() counts from there
ACROSS = math.ceil(MAT / CELL)
log_odds = [0.0] * (ACROSS * ACROSS)  # row after row, from the bottom; 0 is unknown


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
        if tick % 5 == 0:
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


drive(SPEED, 0, TURN)
keep_mapping(360 / (1.2 * TURN))  # once round: TURN is per cent of 120 degrees a second
show()
