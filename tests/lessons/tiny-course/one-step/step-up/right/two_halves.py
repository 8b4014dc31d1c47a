# style: two halves, in a function
from bugbot import *


def half():
    forward(50, 10)


turn(-heading())
half()
half()
