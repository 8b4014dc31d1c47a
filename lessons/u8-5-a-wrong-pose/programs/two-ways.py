# Two ways to know the way
#
# The robot drives round its ring. The camera says where
# it is (black), and the robot itself adds up its steps
# and its gyro (red). The chart shows how far apart they
# have come.

from bugbot import *
import math

# Numbers to change
SECONDS = 60  # how long it drives (10 to 120)
TURN = 25  # how fast it turns, per cent (20 to 60)

START = (72, 100)  # where the robot starts on the mat [cm]

true, believed = [], []
drive(100, 0, TURN)
for tick in range(SECONDS * 5):
    x, y, facing = odometry()
    true.append((START[0] + position()[0], START[1] + position()[1]))
    believed.append((START[0] + x, START[1] + y))
    draw("true", true, "black", "line", 1)
    draw("believed", believed, "red", "line", 1)
    turned = (facing - heading() + 180) % 360 - 180  # -180 to 180
    plot("heading off [degrees]", abs(turned))
    plot("place off [cm]", math.dist(true[-1], believed[-1]))
    wait(0.2)
stop()
