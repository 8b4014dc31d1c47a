# style: it drives sideways and keeps the way it faces
from bugbot import *
from math import cos, radians, sin

some = radians(heading())
drive(50 * cos(some), -50 * sin(some), 0)
while position()[1] < 19.5:
    wait(0.04)
stop()
