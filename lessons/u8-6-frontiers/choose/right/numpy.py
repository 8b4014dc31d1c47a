# style: NumPy: rows of an array
import numpy as np


def nearest_cell(here, region):
    cells = np.array(sorted(region))
    return cells[np.argmin(np.hypot(*(cells - np.array(here)).T))]


def choose(here, regions, gain):
    if len(regions) == 0:
        return None
    cells = [nearest_cell(here, region) for region in regions]
    worth = gain * np.array([len(region) for region in regions])
    worth = worth - np.linalg.norm(np.array(cells) - here, axis=1)
    return cells[worth.argmax()]
