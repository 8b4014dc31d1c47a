# Where it is
#
# The robot drives round a bend. Its trail is drawn
# twice: once as position() gives it, and once with the
# place of the start added. Only one of them is where
# the robot was.

from bugbot import *

# Numbers to change
SPEED = 70  # how fast to drive, per cent (10 to 100)
TURN = 8  # how fast to turn, per cent (-20 to 20)

START = (40, 40)  # where the robot starts on the mat [cm]

as_given, on_the_mat = [], []
drive(SPEED, 0, TURN)
for tick in range(100):  # 10 seconds
    x, y = position()
    as_given.append((x, y))
    on_the_mat.append((START[0] + x, START[1] + y))
    draw("position()", as_given, "red", "dots", 2)
    draw("START + position()", on_the_mat, "blue", "line", 1)
    wait(0.1)
stop()
x, y = position()
print(f"position() says x: {x:.1f}")
print(f"position() says y: {y:.1f}")
print(f"on the mat x: {START[0] + x:.1f}")
print(f"on the mat y: {START[1] + y:.1f}")
