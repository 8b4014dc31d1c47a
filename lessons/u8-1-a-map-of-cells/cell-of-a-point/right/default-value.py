# style: a default value that comes from CELL
from bugbot import *
from math import floor

CELL = 10


def cell_of(x, y, side=CELL):
    return floor(x / side), floor(y / side)
