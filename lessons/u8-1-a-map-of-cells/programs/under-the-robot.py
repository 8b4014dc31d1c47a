# The cell under the robot
#
# The robot drives in a circle. Ten times a
# second the program works out which cell the
# robot's middle is in, and colours the cells
# it has been in.

from bugbot import *
import math

# Numbers to change
CELL = 20  # cm per cell (5 to 50)
SPEED = 80  # per cent forward (0 to 100)
TURN = 12  # per cent turning (-50 to 50)

START = (100, 100)  # position() counts from here

been = []  # the (column, row) of every cell so far
drive(SPEED, 0, TURN)
for tick in range(250):  # 25 seconds
    x = START[0] + position()[0]
    y = START[1] + position()[1]
    column = math.floor(x / CELL)
    row = math.floor(y / CELL)
    plot("column", column)
    plot("row", row)
    if (column, row) not in been:
        been.append((column, row))
        print(f"x {x:.1f} cm, y {y:.1f} cm: column {column}, row {row}")
        middles = [((c + 0.5) * CELL, (r + 0.5) * CELL) for c, r in been]
        draw("been there", middles, "#9ecae1", "squares", CELL)
    wait(0.1)
stop()
print("cells visited:", len(been))
