# style: NumPy: the free grid shifted by every near step
import numpy as np


def find_room(free):
    pad = int(SPARE // CELL) + 2
    grid = np.zeros((ACROSS + 2 * pad, ACROSS + 2 * pad), bool)
    for column, row in free:
        grid[column + pad, row + pad] = True
    room = grid.copy()
    for c in range(-pad, pad + 1):
        for r in range(-pad, pad + 1):
            if np.hypot(c, r) * CELL < SPARE + CELL / 2:
                room &= np.roll(grid, (c, r), (0, 1))
    return set(map(tuple, np.argwhere(room) - pad))
