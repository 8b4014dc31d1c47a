# Off the edge
#
# The robot looks at the right wall of the
# mat. The sensor's noise puts about half of
# the hits a little beyond it. Without a check
# they land somewhere else.

from bugbot import *
import math

# Numbers to change
CHECK = 1  # 0 takes the check away (0 to 1)
LOOKS = 30  # how often the robot looks (1 to 100)

CELL = 5  # cm per cell
MAT = 200  # side of the mat [cm]
START = (100, 100)  # where the robot stands
ACROSS = MAT // CELL
grid = [0] * (ACROSS * ACROSS)  # how many beams ended in each cell

turn(90)  # face the right wall
for look in range(LOOKS):
    for angle, reading in scan():
        direction = math.radians(heading() + angle)
        x = START[0] + reading * math.sin(direction)
        y = START[1] + reading * math.cos(direction)
        column = math.floor(x / CELL)
        row = math.floor(y / CELL)
        on_the_mat = 0 <= column < ACROSS and 0 <= row < ACROSS
        if on_the_mat or not CHECK:
            grid[row * ACROSS + column] += 1
    wait(0.1)

hit = [i for i in range(len(grid)) if grid[i] > 0]
middles = [((i % ACROSS + 0.5) * CELL, (i // ACROSS + 0.5) * CELL) for i in hit]
draw("hit", middles, "black", "squares", CELL)
print("cells hit:", len(hit))
print("of them in column 0, at the left edge:", sum(i % ACROSS == 0 for i in hit))
print("beams counted:", sum(grid))
print("beams sent:", 8 * LOOKS)
