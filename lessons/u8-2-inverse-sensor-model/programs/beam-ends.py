# Where the beams end
#
# The robot turns once round. Each reading
# becomes a point on the mat: a red dot where
# the beam ended.

from bugbot import *
import math

# Numbers to change
SWAP = 0  # 1 swaps sine and cosine (0 to 1)
HEADING = 1  # 0 leaves it out (0 to 1)
SECONDS = 10  # time to turn (1 to 10)

START = (100, 100)  # where the robot stands


def end_of_beam(x, y, angle, reading):
    """The point that lies so far away in this direction."""
    direction = math.radians(angle)
    along_x, along_y = math.sin(direction), math.cos(direction)
    if SWAP:
        along_x, along_y = along_y, along_x
    return x + reading * along_x, y + reading * along_y


ends = []
right(30)  # 36 degrees a second
for tick in range(SECONDS * 10):
    for angle, reading in scan():
        facing = heading() if HEADING else 0
        ends.append(end_of_beam(*START, facing + angle, reading))
    draw("ends", ends, "red", "dots", 1.5)
    wait(0.1)
stop()
print("beams:", len(ends))
