# style: NumPy: rows of an array
import numpy as np


def add_scan(log_odds, x, y, facing, readings):
    rays = np.array(readings)
    rays[:, 0] += facing
    for row in rays:
        add_beam(log_odds, x, y, *row)
