# Demo 2: adding up the evidence
#
# The robot drives 50 cm towards a wall. The chart
# follows the log odds of four cells in one column: the
# floor ahead, the cell in front of the wall, the wall
# itself, and a cell behind it.

from bugbot import *
import math

# Numbers to change
L_OCC = 0.85  # added to the cell a beam ended in (0 to 3)
L_FREE = -0.4  # added at each half-cell step a beam passed (-1 to 0)
L_MAX = 8  # log odds stay between -L_MAX and L_MAX (1 to 100)
KNOWN = 1  # log odds beyond this, either way, count as known (0.5 to 5)
SPEED = 50  # how fast to drive, per cent (10 to 100)

# The mat
CELL = 5  # cm per cell
MAT = 200  # side of the mat [cm]
FAR = 170  # no wall is marked from a reading this long or longer [cm]
START = (100, 40)  # where the robot stands; position() counts from there
ACROSS = math.ceil(MAT / CELL)
log_odds = [0.0] * (ACROSS * ACROSS)  # row after row, from the bottom; 0 is unknown

# The four cells to watch, by their middles. The wall begins at y = 150.
WATCHED = {
    "floor": (102.5, 122.5),
    "in front": (102.5, 147.5),
    "wall": (102.5, 152.5),
    "behind": (102.5, 177.5),
}


def cell_at(x, y):
    """Number of the cell that holds the point, or None beyond the mat."""
    column = math.floor(x / CELL)
    row = math.floor(y / CELL)
    if 0 <= column < ACROSS and 0 <= row < ACROSS:
        return row * ACROSS + column
    return None


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
        cell = cell_at(x + along * dx, y + along * dy)
        if cell is not None:
            log_odds[cell] = max(-L_MAX, min(L_MAX, log_odds[cell] + weight))


def look():
    """Add one scan, 8 beams, from where the robot is."""
    x = START[0] + position()[0]
    y = START[1] + position()[1]
    facing = heading()
    for angle, reading in scan():
        add_beam(x, y, facing + angle, reading)


def centre(cell):
    """The middle of a cell in cm on the mat."""
    return (cell % ACROSS + 0.5) * CELL, (cell // ACROSS + 0.5) * CELL


def show():
    """Draw the map, with the watched cells over it."""
    cells = range(len(log_odds))
    free = [centre(cell) for cell in cells if log_odds[cell] < -KNOWN]
    occupied = [centre(cell) for cell in cells if log_odds[cell] > KNOWN]
    draw("free", free, "#9ecae1", "squares", CELL)
    draw("occupied", occupied, "black", "squares", CELL)
    draw("watched", list(WATCHED.values()), "orange", "dots", 2)


forward(SPEED)
for tick in range(100):  # 10 seconds
    look()
    for name, (x, y) in WATCHED.items():
        plot(name, log_odds[cell_at(x, y)])
    if tick % 5 == 0:
        show()
    if position()[1] >= 50:
        stop()
    wait(0.1)
show()
