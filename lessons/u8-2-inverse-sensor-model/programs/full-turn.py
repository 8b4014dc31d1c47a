# A full turn
#
# The robot turns once round. Cells that beams
# passed are blue, cells where beams ended are
# black, and where the beams disagree the cell
# is orange.

from bugbot import *
import math

# Numbers to change
SHORT = 1  # cells short of a hit (0 to 4)
SECONDS = 10  # time to turn (1 to 10)

CELL = 5  # cm per cell
ACROSS = 40  # cells in a row, and in a column
START = (100, 100)  # where the robot stands
FAR = 170  # a reading this long or longer is no wall


def cell_at(angle, length):
    """The cell so far from the robot in this direction; None beyond the mat."""
    direction = math.radians(angle)
    column = math.floor((START[0] + length * math.sin(direction)) / CELL)
    row = math.floor((START[1] + length * math.cos(direction)) / CELL)
    return (column, row) if 0 <= column < ACROSS and 0 <= row < ACROSS else None


def show(name, cells, colour):
    middles = [((column + 0.5) * CELL, (row + 0.5) * CELL) for column, row in sorted(cells)]
    draw(name, middles, colour, "squares", CELL)


free, hit = set(), set()
right(30)  # 36 degrees a second
for tick in range(SECONDS * 10):
    for turned, reading in scan():
        angle = heading() + turned
        clear = min(reading, FAR) if reading >= FAR else reading - SHORT * CELL
        free.update(cell_at(angle, i * CELL / 2) for i in range(int(clear / (CELL / 2))))
        if reading < FAR:
            hit.add(cell_at(angle, reading))
    free.discard(None)
    hit.discard(None)
    if tick % 5 == 0 or tick == SECONDS * 10 - 1:
        show("free", free - hit, "#9ecae1")
        show("hit", hit - free, "black")
        show("both", free & hit, "orange")
        plot("free", len(free - hit))
        plot("hit", len(hit - free))
        plot("both", len(free & hit))
    wait(0.1)
stop()
print("cells free:", len(free - hit), "hit:", len(hit - free), "both:", len(free & hit))
