# A reading of nothing
#
# The robot stands in a corner, so the far
# corner of the mat is out of its sensor's
# reach. Readings of FAR or more are not taken
# for walls.

from bugbot import *
import math

# Numbers to change
FAR = 201  # from here on no wall, cm (100 to 201)

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row, and in a column
START = (30, 30)  # where the robot stands

hits = set()
readings = nothing = 0
turn(-45)  # from here the robot turns to the right through a quarter circle
right(20)  # 24 degrees a second
for tick in range(38):
    for angle, reading in scan():
        readings += 1
        nothing += reading == 200
        if reading < FAR:
            direction = math.radians(heading() + angle)
            column = math.floor((START[0] + reading * math.sin(direction)) / CELL)
            row = math.floor((START[1] + reading * math.cos(direction)) / CELL)
            if 0 <= column < ACROSS and 0 <= row < ACROSS:
                hits.add((column, row))
    middles = [((column + 0.5) * CELL, (row + 0.5) * CELL) for column, row in sorted(hits)]
    draw("hit", middles, "black", "squares", CELL)
    wait(0.1)
stop()

inside = [(c, r) for c, r in hits if 2 <= c < ACROSS - 2 and 2 <= r < ACROSS - 2]
print("readings:", readings)
print("readings of exactly 200:", nothing)
print("cells hit:", len(hits))
print("of them well inside the mat:", len(inside))
