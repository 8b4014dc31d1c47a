# earns: (100.0, 90.0)
# Where a beam ends
#
# Write end_of_beam, then press Run. The red
# dots should lie along the wall.

from bugbot import *
import math

START = (100, 40)  # position() counts from here


def end_of_beam(x, y, angle, reading):
    """The point where a beam ended."""
    # ---- your part ----
    if angle > 360:
        angle = 360
    direction = math.radians(angle)
    end_x = x + reading * math.sin(direction)
    end_y = y + reading * math.cos(direction)
    # ---- end of your part ----
    return end_x, end_y


# From here on the program only shows what end_of_beam does.
ends = []
turn(-30)
for look in range(4):
    x = START[0] + position()[0]
    y = START[1] + position()[1]
    beams = []
    for angle, reading in scan():
        end = end_of_beam(x, y, heading() + angle, reading)
        beams += [(x, y), end]
        ends.append(end)
    draw("beams", beams, "orange", "line", 0.5)
    draw("ends", ends, "red", "dots", 2)
    wait(0.5)
    turn(20)
print("the last beam ended at", ends[-1])
