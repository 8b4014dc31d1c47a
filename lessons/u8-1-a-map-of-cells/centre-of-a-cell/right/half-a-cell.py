# style: half a cell, worked out once
from bugbot import *

CELL = 10
HALF = CELL / 2


def centre_of(column, row):
    return column * CELL + HALF, row * CELL + HALF
