# The same with NumPy
#
# The robot turns once round and keeps every
# point where a beam ended. At the end all the
# points become cells at once, and the grid is
# an array of two dimensions.

from bugbot import *
import math
import numpy as np

# Numbers to change
CELL = 20  # cm per cell (5 to 50)

MAT = 200  # side of the mat [cm]
START = (100, 100)  # where the robot stands
ACROSS = math.ceil(MAT / CELL)

ends = []
right(30)  # 36 degrees a second
for tick in range(100):
    for angle, reading in scan():
        direction = math.radians(heading() + angle)
        ends.append(
            (START[0] + reading * math.sin(direction), START[1] + reading * math.cos(direction))
        )
    wait(0.1)
stop()

points = np.array(ends)  # one row for each point: x and y
cells = np.floor(points / CELL).astype(int)  # one row for each point: column and row
on_the_mat = np.all((cells >= 0) & (cells < ACROSS), axis=1)
columns, rows = cells[on_the_mat].T

grid = np.zeros((ACROSS, ACROSS), dtype=int)
np.add.at(grid, (rows, columns), 1)  # row first, then column

hit_rows, hit_columns = np.nonzero(grid)
middles = (np.column_stack([hit_columns, hit_rows]) + 0.5) * CELL
draw("hit", middles.tolist(), "black", "squares", CELL)
print(grid[::-1])  # upside down, so that row 0 is at the bottom as on the mat
print("points:", len(points))
print("points on the mat:", int(on_the_mat.sum()))
print("cells hit:", len(middles))
