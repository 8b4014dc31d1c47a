# earns: math.radians() got only one
# Where it is on the mat
#
# The robot drives round a bend and looks as it goes.
# Draw its trail, and a dot where each beam ended. If
# the pose is right, the dots lie on the walls.

from bugbot import *
import math

FAR = 170  # a reading this long or longer found no wall [cm]
START = (40, 40)  # where it starts; position() counts from there

trail = []  # where the robot has been, in cm on the mat
walls = []  # where beams ended, in cm on the mat


# ---- your part ----
def pose():
    """Now: x and y on the mat in cm, and the heading."""
    x, y = position()
    return START[0] + x, START[1] + y, heading()


def look():
    """Add to `trail` where it is, to `walls` where beams ended."""
    x, y, facing = pose()
    trail.append((x, y))
    for angle, reading in scan():
        if reading < FAR:
            way = math.radians(facing) + angle
            walls.append((x + reading * math.sin(way), y + reading * math.cos(way)))


# ---- end of your part ----

drive(70, 0, 8)
for tick in range(100):  # 10 seconds
    look()
    draw("trail", trail, "green", "line", 1)
    draw("walls", walls, "red", "dots", 2)
    wait(0.1)
stop()
