# The whole mapper with NumPy
#
# The map is a table with 40 rows and 40 columns, and a
# scan is added to it all at once: the steps of its
# eight beams are a table too, a row for each beam.

from bugbot import *
import numpy as np

# Numbers to change
L_OCC = 0.85  # evidence of a hit (0 to 2)
L_FREE = -0.4  # evidence of each step of a pass (-1 to 0)
L_MAX = 8  # the clamp (1 to 20)
KNOWN = 1  # beyond this, either way, a cell is known (0.1 to 5)

CELL, ACROSS, FAR, START = 5, 40, 170, (72, 100)
log_odds = np.zeros((ACROSS, ACROSS))  # [row, column]
ALONG = np.arange(0, FAR, CELL / 2)  # half-cell steps


def add(xs, ys, evidence):
    """Add evidence to the cells of many points at once."""
    columns = np.floor(xs / CELL).astype(int)
    rows = np.floor(ys / CELL).astype(int)
    on_mat = (columns >= 0) & (columns < ACROSS) & (rows >= 0) & (rows < ACROSS)
    np.add.at(log_odds, (rows[on_mat], columns[on_mat]), evidence)
    np.clip(log_odds, -L_MAX, L_MAX, out=log_odds)


def look():
    """Add a whole scan from where the robot is."""
    x, y = START[0] + position()[0], START[1] + position()[1]
    angles, readings = np.array(scan()).T
    way = np.radians(heading() + angles)
    steps = np.floor(np.where(readings < FAR, readings - CELL, FAR) / (CELL / 2))
    passed = np.arange(len(ALONG)) < steps[:, None]  # eight rows
    dx, dy = np.sin(way)[:, None], np.cos(way)[:, None]
    add((x + ALONG * dx)[passed], (y + ALONG * dy)[passed], L_FREE)
    hit = readings < FAR
    add((x + readings * np.sin(way))[hit], (y + readings * np.cos(way))[hit], L_OCC)


def middles(cells):
    """Where the cells are that are True, in cm."""
    rows, columns = np.nonzero(cells)
    return np.column_stack((columns + 0.5, rows + 0.5)) * CELL


def show():
    """Draw the map, and plot how much of the mat is known."""
    draw("free", middles(log_odds < -KNOWN), "#9ecae1", "squares", CELL)
    draw("occupied", middles(log_odds > KNOWN), "black", "squares", CELL)
    plot("known %", 100 * np.mean(np.abs(log_odds) > KNOWN))


drive(100, 0, 25)
for tick in range(120):  # 12 seconds, once round the circle
    look()
    if tick % 5 == 0:
        show()
    wait(0.1)
stop()
show()
