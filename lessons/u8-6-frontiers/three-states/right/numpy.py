# style: NumPy: arrays of cells and values
import numpy as np


def read_map(log_odds):
    cells = list(log_odds)
    p = 1 / (1 + np.exp(-np.array([log_odds[cell] for cell in cells])))
    pick = lambda mask: {cells[i] for i in np.flatnonzero(mask)}
    return pick(p < FREE_P), pick(p > OCC_P)
