# Two thresholds for one file
#
# A map becomes an image of three greys, and a reader turns
# the greys into cells again. What it makes of grey 205
# depends on one number.

from bugbot import *
import numpy as np

FREE_THRESH = 0.196  # p of a pixel up to here is free for the reader (0.1 to 0.4)

CELL, ACROSS, FAR = 5, 40, 170
START = np.array([100, 25])
log_odds = np.zeros((ACROSS, ACROSS))  # a row of the array is a row of the mat
ALONG = np.arange(0, FAR, CELL / 2)


def look():
    angles, readings = np.array(scan()).T
    way = np.radians(heading() + angles)
    ahead = np.stack([np.sin(way), np.cos(way)], axis=-1)
    here = START + position()
    clear = np.where(readings < FAR, readings - CELL, FAR)
    passed = here + ALONG[None, :, None] * ahead[:, None, :]
    add(passed[ALONG[None, :] + CELL / 2 <= clear[:, None]], -0.4)
    hits = readings < FAR
    add((here + readings[:, None] * ahead)[hits], 0.85)


def add(points, weight):
    cells = np.floor(points / CELL).astype(int)
    column, row = cells[((cells >= 0) & (cells < ACROSS)).all(axis=1)].T
    np.add.at(log_odds, (row, column), weight)
    np.clip(log_odds, -8, 8, out=log_odds)


right(60)
for tick in range(50):
    look()
    wait(0.1)
stop()

# Written: three states as greys, the top row first.
p = 1 - 1 / (1 + np.exp(log_odds))
image = np.select([p > 0.65, p < 0.35], [0, 254], 205)[::-1]

# Read: dark is occupied, and up to the threshold is free.
grey_p = (255 - image) / 255
read = np.select([grey_p >= 0.65, grey_p <= FREE_THRESH], [100, 0], -1)[::-1]

for name, value, colour in [("free", 0, "#9ecae1"), ("occupied", 100, "black")]:
    rows, columns = np.nonzero(read == value)
    draw(name, np.stack([columns + 0.5, rows + 0.5], axis=1) * CELL, colour, "squares", CELL)
print(
    f"written: free {np.sum(image == 254)}, occupied {np.sum(image == 0)}, "
    f"unknown {np.sum(image == 205)}"
)
print(
    f"read: free {np.sum(read == 0)}, occupied {np.sum(read == 100)}, unknown {np.sum(read == -1)}"
)
