# earns: or show draws only one of the cells
# Draw the cells
#
# Fill in mark and show, then press Run. Every
# cell the robot has been in should be
# coloured.

from bugbot import *
import math

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row, and in a column
START = (100, 100)  # position() counts from here

visited = [False] * (ACROSS * ACROSS)  # row after row, from the bottom


def mark():
    """Note the cell the robot is in now."""
    x, y = position()
    index = index_of(START[0] + x, START[1] + y)
    if index is not None:
        visited[index] = True


def show():
    """Draw every visited cell."""
    middles = []  # of all visited cells
    for index in range(len(visited)):
        if index == visited.index(True):
            column = index % ACROSS
            row = index // ACROSS
            middles.append(((column + 0.5) * CELL, (row + 0.5) * CELL))
    draw("visited", middles, "#9ecae1", "squares", CELL)


# This one is for you to use.
def index_of(x, y):
    """A point's index in the list, or None."""
    column = math.floor(x / CELL)
    row = math.floor(y / CELL)
    if 0 <= column < ACROSS and 0 <= row < ACROSS:
        return row * ACROSS + column
    return None


drive(70, 0, 15)  # forward, turning a little to the right
for tick in range(200):
    mark()
    if tick % 5 == 0:
        show()
    wait(0.1)
stop()
mark()
show()
print("cells visited:", sum(visited))
