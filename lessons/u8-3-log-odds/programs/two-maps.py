# Two maps added
#
# The robot maps from one spot, drives on, and maps from
# another into a second, empty grid. Log odds add, so
# the two grids become one map with a single +.

from bugbot import *
import math
import numpy as np

# Numbers to change
L_OCC = 0.85  # added to the cell a beam ended in (0 to 2)
L_FREE = -0.4  # added at each step of a pass (-1 to 0)
L_MAX = 8  # the clamp (1 to 20)
KNOWN = 1  # beyond this, either way, a cell is known (0.5 to 5)
DRIVE = 55  # how far apart the two spots are [cm] (0 to 80)

START, CELL, ACROSS, FAR = (100, 100), 5, 40, 170


def map_here():
    """A grid of what one turn on the spot sees."""
    grid = np.zeros((ACROSS, ACROSS))
    x, y = START[0] + position()[0], START[1] + position()[1]
    right(40)
    for tick in range(80):
        for angle, reading in scan():
            way = math.radians(heading() + angle)
            clear = reading - CELL if reading < FAR else FAR
            along = np.arange(0, int(clear / 2.5)) * 2.5
            add(grid, x + along * math.sin(way), y + along * math.cos(way), L_FREE)
            if reading < FAR:
                end = np.array([reading])
                add(grid, x + end * math.sin(way), y + end * math.cos(way), L_OCC)
        wait(0.1)
    stop()
    return np.clip(grid, -L_MAX, L_MAX)


def add(grid, xs, ys, evidence):
    """Add evidence to the cells of many points at once."""
    columns = np.floor(xs / CELL).astype(int)
    rows = np.floor(ys / CELL).astype(int)
    on_mat = (columns >= 0) & (columns < ACROSS) & (rows >= 0) & (rows < ACROSS)
    np.add.at(grid, (rows[on_mat], columns[on_mat]), evidence)


def middles(cells):
    """Where the cells are that are True, in cm."""
    rows, columns = np.nonzero(cells)
    return np.column_stack((columns + 0.5, rows + 0.5)) * CELL


def show(grid):
    """Draw a grid, and give the share of cells it knows."""
    draw("free", middles(grid < -KNOWN), "#9ecae1", "squares", CELL)
    draw("occupied", middles(grid > KNOWN), "black", "squares", CELL)
    known = 100 * np.mean(np.abs(grid) > KNOWN)
    plot("known %", known)
    return known


first = map_here()
print(f"first spot: {show(first):.1f} % known")
turn(180 - heading())
forward(80, distance=DRIVE)
second = map_here()
print(f"second spot: {show(second):.1f} % known")
wait(2)
both = np.clip(first + second, -L_MAX, L_MAX)
print(f"added: {show(both):.1f} % known")
wait(1)
