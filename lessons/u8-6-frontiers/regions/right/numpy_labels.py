# style: NumPy: the largest number of the neighbours, until nothing changes
import numpy as np


def find_regions(cells):
    labels = np.zeros((ACROSS + 2, ACROSS + 2), dtype=int)
    for number, (column, row) in enumerate(cells, start=1):
        labels[column + 1, row + 1] = number
    there = labels > 0
    while True:
        best = labels.copy()
        for c in (-1, 0, 1):
            for r in (-1, 0, 1):
                best = np.maximum(best, np.roll(labels, (c, r), (0, 1)))
        best *= there
        if (best == labels).all():
            break
        labels = best
    return [
        {tuple(cell) for cell in np.argwhere(labels == label) - 1}
        for label in np.unique(labels[there])
    ]
