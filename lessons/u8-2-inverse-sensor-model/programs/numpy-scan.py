# A whole scan with NumPy
#
# All the steps of all eight beams are worked
# out at once, as arrays of eight rows. Two
# grids count how often each cell was passed
# and how often it was hit.

from bugbot import *
import numpy as np

# Numbers to change
CELL = 5  # cm per cell (2 to 20)
SECONDS = 10  # time to turn (1 to 10)

MAT = 200  # side of the mat [cm]
START = (100, 100)  # where the robot stands
FAR = 170  # a reading this long or longer is no wall
ACROSS = int(np.ceil(MAT / CELL))

passed = np.zeros((ACROSS, ACROSS), dtype=int)  # [row, column]
hit = np.zeros((ACROSS, ACROSS), dtype=int)
along = np.arange(0, FAR, CELL / 2)  # half-cell steps, as long as any beam needs


def count(grid, x, y):
    """Add 1 to the cell of each point (x, y) that lies on the mat."""
    columns = np.floor(x / CELL).astype(int)
    rows = np.floor(y / CELL).astype(int)
    on_the_mat = (columns >= 0) & (columns < ACROSS) & (rows >= 0) & (rows < ACROSS)
    np.add.at(grid, (rows[on_the_mat], columns[on_the_mat]), 1)


def look():
    angles, readings = np.array(scan()).T  # eight angles, eight readings
    directions = np.radians(heading() + angles)
    along_x, along_y = np.sin(directions), np.cos(directions)
    walls = readings < FAR
    clear = np.where(walls, readings - CELL, FAR)
    # A column of eight beams and a row of steps make a table of eight by many points.
    x = START[0] + along_x[:, None] * along
    y = START[1] + along_y[:, None] * along
    near_enough = along < clear[:, None]
    count(passed, x[near_enough], y[near_enough])
    ends_x = START[0] + along_x * readings
    ends_y = START[1] + along_y * readings
    count(hit, ends_x[walls], ends_y[walls])


def show(name, where, colour):
    rows, columns = np.nonzero(where)
    middles = (np.column_stack([columns, rows]) + 0.5) * CELL
    draw(name, middles.tolist(), colour, "squares", CELL)


right(30)  # 36 degrees a second
for tick in range(SECONDS * 10):
    look()
    wait(0.1)
stop()
show("free", (passed > 0) & (hit == 0), "#9ecae1")
show("hit", hit > 0, "black")
print("the most often passed:", passed.max(), "times")
print("the most often hit:", hit.max(), "times")
print("cells passed:", int((passed > 0).sum()), "cells hit:", int((hit > 0).sum()))
