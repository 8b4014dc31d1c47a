# style: a class for the grid
from bugbot import *

CELL = 10


class Grid:
    def __init__(self, side):
        self.side = side

    def centre(self, column, row):
        return self.side * (column + 0.5), self.side * (row + 0.5)


grid = Grid(CELL)
centre_of = grid.centre
