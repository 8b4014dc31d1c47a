# The same look with larger and smaller cells
#
# The robot turns once round. Each cell in
# which a beam ended is coloured black. (How
# the end of a beam is found is the subject of
# the next lesson.)

from bugbot import *
import math

# Numbers to change
CELL = 5  # cm per cell (2 to 50)
SECONDS = 12  # time to turn (1 to 12)

MAT = 200  # side of the mat [cm]
START = (100, 100)  # where the robot stands
ACROSS = math.ceil(MAT / CELL)  # cells in a row, and in a column

hits = set()
right(30)  # 36 degrees a second
for tick in range(SECONDS * 10):
    for angle, reading in scan():
        direction = math.radians(heading() + angle)
        x = START[0] + reading * math.sin(direction)
        y = START[1] + reading * math.cos(direction)
        column = math.floor(x / CELL)
        row = math.floor(y / CELL)
        if 0 <= column < ACROSS and 0 <= row < ACROSS:
            hits.add((column, row))
    if tick % 5 == 0:
        middles = [((c + 0.5) * CELL, (r + 0.5) * CELL) for c, r in sorted(hits)]
        draw("hit", middles, "black", "squares", CELL)
        plot("cells hit", len(hits))
    wait(0.1)
stop()
print("cells across:", ACROSS)
print("cells on the mat:", ACROSS * ACROSS)
print("cells hit:", len(hits))
print("mat covered by hit cells, per cent:", round(100 * len(hits) / ACROSS**2, 1))
