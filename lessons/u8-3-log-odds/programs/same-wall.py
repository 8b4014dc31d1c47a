# The same wall, many times
#
# The robot stands still, 110 cm from a wall, and looks
# straight ahead again and again. The wall does not
# move. The readings do.

from bugbot import *
import math

# Numbers to change
LOOKS = 60  # how often to look (1 to 300)
CELL = 5  # cm per cell (2 to 20)

START = (100, 40)  # where the robot stands on the mat

lowest, highest = 200, 0
count = {}  # row of cells -> how many readings ended in it
dots = []
for look in range(LOOKS):
    reading = distance()
    end = START[1] + reading  # straight up the mat
    row = math.floor(end / CELL)
    count[row] = count.get(row, 0) + 1
    lowest, highest = min(lowest, reading), max(highest, reading)
    dots.append((START[0] + look % 20 - 10, end))
    plot("reading", reading)
    draw("where readings ended", dots, "red", "dots", 1)
    wait(0.1)

print(f"lowest reading {lowest:.1f} cm, highest {highest:.1f} cm")
for row in sorted(count):
    print(f"ended between {row * CELL} and {row * CELL + CELL} cm: {count[row]}")
