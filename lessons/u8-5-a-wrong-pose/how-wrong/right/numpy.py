# style: NumPy: the nearest point of every rectangle at once
import numpy as np


def gap(x, y, real):
    gaps = [x, MAT - x, y, MAT - y]
    if len(real):
        left, bottom, width, height = np.array(real, float).T
        near_x = np.clip(x, left, left + width)
        near_y = np.clip(y, bottom, bottom + height)
        gaps = np.append(gaps, np.hypot(x - near_x, y - near_y))
    return np.min(gaps)


def wrong_percent(occupied, real):
    if len(occupied) == 0:
        return 0.0
    return 100 * np.mean([gap(x, y, real) > CELL for x, y in occupied])
