# style: backwards, by hand
from bugbot import *

turn(180 - heading())
backward(50, distance=20)
