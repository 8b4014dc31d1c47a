# task: cell
# tries: the inner parts by way of the package
# told: line 8: bugbot has no call 'frames' that a program may use
import bugbot as robot


def cell_of(x, y):
    return robot.frames.cell_of(x, y, 10)
