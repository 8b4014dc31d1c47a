# style: NumPy: the grid shifted to four sides
import numpy as np


def find_frontier(free, occupied):
    grid = np.zeros((ACROSS + 2, ACROSS + 2), dtype=int)
    grid[1:-1, 1:-1] = 1
    for column, row in occupied:
        grid[column + 1, row + 1] = 2
    is_free = np.zeros_like(grid, dtype=bool)
    for column, row in free:
        grid[column + 1, row + 1] = 2
        is_free[column + 1, row + 1] = True
    unknown = grid == 1
    beside = np.zeros_like(unknown)
    for axis in (0, 1):
        for by in (-1, 1):
            beside |= np.roll(unknown, by, axis)
    columns, rows = np.nonzero(is_free & beside)
    return set(zip(columns - 1, rows - 1))
