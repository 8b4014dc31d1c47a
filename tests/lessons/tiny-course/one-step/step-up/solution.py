from bugbot import *

turn(-heading())
forward(50, 20)
