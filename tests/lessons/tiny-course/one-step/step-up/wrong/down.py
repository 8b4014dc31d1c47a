# earns: it went down
from bugbot import *

turn(180 - heading())
forward(50, 20)
