# earns: column and row look swapped
# Draw the cells
#
# The robot drives off. Ten times a second the program calls mark, and twice a second
# show. Fill in both, so that every cell the robot has been in is coloured.

from bugbot import *
import math

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row, and in a column
START = (100, 100)  # where the robot starts on the mat; position() counts from there

visited = [False] * (ACROSS * ACROSS)  # row after row, from the bottom


def index_of(x, y):
    """The place in the list of the cell that holds (x, y); None beyond the mat."""
    column = math.floor(x / CELL)
    row = math.floor(y / CELL)
    if 0 <= column < ACROSS and 0 <= row < ACROSS:
        return row * ACROSS + column
    return None


def mark():
    """Note in the list that the robot has been in the cell it is in now."""
    x, y = position()
    index = index_of(START[0] + x, START[1] + y)
    if index is not None:
        visited[index] = True


def show():
    """Draw every visited cell."""
    middles = []
    for index in range(len(visited)):
        if visited[index]:
            column = index // ACROSS
            row = index % ACROSS
            middles.append(((column + 0.5) * CELL, (row + 0.5) * CELL))
    draw("visited", middles, "#9ecae1", "squares", CELL)


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
