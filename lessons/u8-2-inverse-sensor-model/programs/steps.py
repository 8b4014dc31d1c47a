# Steps along a beam
#
# A beam of 150 cm, and the cells that are
# found by walking along it in steps. The
# cells that it really crosses, but that no
# step fell into, are orange.

from bugbot import *
import math

# Numbers to change
STEP = 1  # step, in cells (0.1 to 2)
ANGLE = 25  # degrees clockwise (0 to 90)

CELL = 10  # cm per cell
START = (25, 25)  # where the beam begins
LENGTH = 150  # cm


def walk(step):
    """The points along the beam, `step` cm apart, and the cells that hold them."""
    direction = math.radians(ANGLE)
    points, cells = [], set()
    for i in range(int(LENGTH / step) + 1):
        x = START[0] + i * step * math.sin(direction)
        y = START[1] + i * step * math.cos(direction)
        points.append((x, y))
        cells.add((math.floor(x / CELL), math.floor(y / CELL)))
    return points, cells


def middles(cells):
    return [((column + 0.5) * CELL, (row + 0.5) * CELL) for column, row in sorted(cells)]


crossed = walk(0.01 * CELL)[1]  # steps so small that hardly a corner is missed
points, found = walk(STEP * CELL)
missed = crossed - found

draw("found", middles(found), "#9ecae1", "squares", CELL)
draw("missed", middles(missed), "orange", "squares", CELL)
draw("beam", [points[0], points[-1]], "black", "line", 0.5)
draw("steps", points, "red", "dots", 2)
print("steps:", len(points))
print("cells crossed:", len(crossed))
print("cells found:", len(found))
print("cells missed:", len(missed))
