# earns: the first number is never below 0
# Drive any way
#
# The robot can move to any side while it turns. You say
# where it should go on the mat; work out how much of that
# is ahead for the robot, and how much to its right.

from bugbot import *
import math

START = (100, 25)  # where it starts; position() counts from there
SPIN = 60  # per cent: how fast it turns meanwhile


# ---- your part ----
def speeds(dx, dy, facing):
    if dx == 0 and dy == 0:
        return 0, 0
    off = math.atan2(dx, dy) - math.radians(facing)
    return abs(100 * math.cos(off)), 100 * math.sin(off)


# ---- end of your part ----


# The rest is done: round a square, turning all the time.
trail = []
for target in [(140, 60), (140, 100), (60, 100), (60, 60), (100, 60)]:
    draw("target", [target], "red", "dots", 5)
    for tick in range(200):  # 20 seconds at most for each side
        x, y = START[0] + position()[0], START[1] + position()[1]
        trail.append((x, y))
        if math.dist((x, y), target) < 2:
            break
        # It turns on while it drives: half of a tick's turn is added.
        forwards, to_the_right = speeds(target[0] - x, target[1] - y, heading() + 0.06 * SPIN)
        drive(forwards, to_the_right, SPIN)
        wait(0.1)
    draw("trail", trail, "green", "line", 1)
stop()
print(f"{clock():.1f} s, {heading():.0f} degrees")
