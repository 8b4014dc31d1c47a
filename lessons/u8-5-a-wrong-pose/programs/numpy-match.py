# All poses at once with NumPy
#
# The robot turns once for a map, and looks a while longer.
# More than a thousand poses are tried, once with loops
# and once with NumPy. Which takes how long?

from bugbot import *
import math
from timeit import timeit
import numpy as np

# Numbers to change
PLACES = 4  # places to try on either side, along x and y, 1 cm apart (1 to 8)

CELL, ACROSS, FAR, START = 5, 40, 170, (72, 100)
TURNS = np.arange(-3, 3.1, 0.5)  # headings to try, from the guess [degrees]
SHIFTS = np.arange(-PLACES, PLACES + 1)


def with_loops(field, x, y, facing, hits):
    """The best pose: pose after pose, hit after hit."""
    best, most = None, -1
    cells = field.tolist()
    for turned in TURNS.tolist():
        way = math.radians(facing + turned)
        sine, cosine = math.sin(way), math.cos(way)
        for dx in SHIFTS.tolist():
            for dy in SHIFTS.tolist():
                total = 0
                for ahead, right in hits.tolist():
                    column = int((x + dx + ahead * sine + right * cosine) // CELL)
                    row = int((y + dy + ahead * cosine - right * sine) // CELL)
                    if 0 <= column < ACROSS and 0 <= row < ACROSS:
                        total += cells[row][column]
                if total > most:
                    best, most = (x + dx, y + dy, facing + turned), total
    return best


def with_numpy(field, x, y, facing, hits):
    """The best pose: one array over headings, both shifts and hits."""
    way = np.radians(facing + TURNS)[:, None]
    ahead, right = hits.T
    xs = x + ahead * np.sin(way) + right * np.cos(way)  # a row a heading
    ys = y + ahead * np.cos(way) - right * np.sin(way)
    columns = ((xs[:, None, :] + SHIFTS[:, None]) // CELL).astype(int)
    rows = ((ys[:, None, :] + SHIFTS[:, None]) // CELL).astype(int)
    padded = np.pad(field, 1)  # a border of 0 for what is beyond the mat
    columns = np.clip(columns + 1, 0, ACROSS + 1)[:, :, None, :]
    rows = np.clip(rows + 1, 0, ACROSS + 1)[:, None, :, :]
    total = padded[rows, columns].sum(axis=-1)  # [heading, dx, dy]
    turned, dx, dy = np.unravel_index(total.argmax(), total.shape)
    return x + SHIFTS[dx], y + SHIFTS[dy], facing + TURNS[turned]


hit_count = np.zeros((ACROSS, ACROSS))
hits = []
right(50)  # 60 degrees a second
for tick in range(80):  # once round, and a third of a turn more
    angles, readings = np.array(scan()).T
    near = readings < FAR
    way = np.radians(heading() + angles[near])
    xs, ys = readings[near] * np.sin(way), readings[near] * np.cos(way)
    if tick < 60:
        columns = np.clip((START[0] + xs) // CELL, 0, ACROSS - 1).astype(int)
        rows = np.clip((START[1] + ys) // CELL, 0, ACROSS - 1).astype(int)
        np.add.at(hit_count, (rows, columns), 1)
    else:
        hits.append(np.column_stack((ys, xs)))
    wait(0.1)
stop()
hits = np.concatenate(hits)
field = np.minimum(hit_count, 3) / 3
guess = START[0] + 2, START[1] - 2, 2.0
print(f"poses: {len(TURNS) * len(SHIFTS) ** 2}, hits: {len(hits)}")
for name, match in (("loops", with_loops), ("NumPy", with_numpy)):
    x, y, facing = match(field, *guess, hits)
    # timeit() asks the computer's clock, not the robot's.
    took = timeit("match(field, *guess, hits)", globals=globals(), number=1)
    print(f"{name}: x {x:g}, y {y:g}, heading {facing:g}")
    print(f"{name} took: {1000 * took:.1f} ms")
