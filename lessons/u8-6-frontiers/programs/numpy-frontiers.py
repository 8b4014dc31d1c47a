# Frontiers with NumPy
#
# The same map twice: as a dictionary of cells, and as an
# array of 40 rows and 40 columns. Both ways of finding the
# frontier are timed with the computer's own clock.

from bugbot import *
from timeit import timeit

import numpy as np

# Numbers to change
REPEATS = 50  # how often each way is timed (10 to 500)
KNOWN = 0.62  # log odds beyond this, either way, are known (0.1 to 5)

CELL, ACROSS, FAR, START = 5, 40, 170, (100, 25)
L_OCC, L_FREE, L_MAX = 0.85, -0.4, 8
SIDES = [(-1, 0), (1, 0), (0, -1), (0, 1)]
log_odds = np.zeros((ACROSS, ACROSS))  # [row, column]
ALONG = np.arange(0, FAR, CELL / 2)  # half-cell steps


def add(xs, ys, evidence):
    """Add evidence to the cells of many points at once."""
    columns, rows = np.floor(xs / CELL).astype(int), np.floor(ys / CELL).astype(int)
    on_mat = (columns >= 0) & (columns < ACROSS) & (rows >= 0) & (rows < ACROSS)
    np.add.at(log_odds, (rows[on_mat], columns[on_mat]), evidence)
    np.clip(log_odds, -L_MAX, L_MAX, out=log_odds)


def look():
    """Add a whole scan."""
    angles, readings = np.array(scan()).T
    way = np.radians(heading() + angles)
    dx, dy = np.sin(way), np.cos(way)
    clear = np.where(readings < FAR, readings - CELL, FAR)
    passed = np.arange(len(ALONG)) < np.floor(clear / (CELL / 2))[:, None]
    add((START[0] + ALONG * dx[:, None])[passed], (START[1] + ALONG * dy[:, None])[passed], L_FREE)
    hit = readings < FAR
    add((START[0] + readings * dx)[hit], (START[1] + readings * dy)[hit], L_OCC)


def frontier_of_sets(cells):
    """As in this lesson: cells are keys of a dictionary."""
    free = {cell for cell, l in cells.items() if l < -KNOWN}
    unknown = {cell for cell, l in cells.items() if -KNOWN <= l <= KNOWN}
    return {
        (column, row)
        for column, row in free
        if any((column + c, row + r) in unknown for c, r in SIDES)
    }


def frontier_of_array(cells):
    """The same as an array of True and False: the unknown, shifted by one cell in four ways."""
    free, unknown = cells < -KNOWN, np.abs(cells) <= KNOWN
    beside = np.zeros_like(unknown)
    beside[1:] |= unknown[:-1]  # the cell below is unknown
    beside[:-1] |= unknown[1:]  # the cell above
    beside[:, 1:] |= unknown[:, :-1]  # the cell on the left
    beside[:, :-1] |= unknown[:, 1:]  # the cell on the right
    return free & beside


def milliseconds(find, cells):
    """How long one call takes: timeit() asks the computer's clock, not the robot's."""
    return timeit(lambda: find(cells), number=REPEATS) * 1000 / REPEATS


right(60)
for tick in range(50):
    look()
    wait(0.1)
stop()
as_dictionary = {(c, r): float(log_odds[r, c]) for r in range(ACROSS) for c in range(ACROSS)}
sets, array = frontier_of_sets(as_dictionary), frontier_of_array(log_odds)
rows, columns = np.nonzero(array)
draw("frontier", np.column_stack((columns + 0.5, rows + 0.5)) * CELL, "gold", "squares", CELL)
same = sets == set(zip(columns.tolist(), rows.tolist()))
print(
    "frontier cells:",
    len(sets),
    "and",
    int(array.sum()),
    "(the same)" if same else "(not the same)",
)
slow, fast = (
    milliseconds(frontier_of_sets, as_dictionary),
    milliseconds(frontier_of_array, log_odds),
)
print(f"sets: {slow:.3f} ms")
print(f"array: {fast:.3f} ms")
print(f"times faster: {slow / fast:.0f}")
