# style: a lambda
from bugbot import *
from math import floor

CELL = 10
cell_of = lambda x, y: (floor(x / CELL), floor(y / CELL))
