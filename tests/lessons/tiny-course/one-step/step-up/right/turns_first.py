# style: a heading asked for in a loop
from bugbot import *

while abs(heading()) > 0.5 and heading() < 359.5:
    turn(heading() - 360 if heading() > 180 else -heading())
forward(50, 20)
