# style: divmod, and no use of index_of
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
    x += START[0]
    y += START[1]
    column, row = int(x // CELL), int(y // CELL)
    if 0 <= column < ACROSS and 0 <= row < ACROSS:
        visited[row * ACROSS + column] = True


def show():
    """Draw every visited cell."""
    middles = []  # of all visited cells
    place = 0
    while place < len(visited):
        row, column = divmod(place, ACROSS)
        if visited[place] is True:
            middles.append(((column + 0.5) * CELL, (row + 0.5) * CELL))
        place += 1
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
