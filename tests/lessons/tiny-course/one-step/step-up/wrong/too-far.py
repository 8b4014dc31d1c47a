# earns: it went too far
from bugbot import *

turn(-heading())
forward(50, 30)
