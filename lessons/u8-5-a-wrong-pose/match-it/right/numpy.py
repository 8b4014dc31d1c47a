# style: NumPy: all hits of a pose at once
import numpy as np


def fit(field, x, y, facing, hits):
    grid = np.array(field, float).reshape(ACROSS, ACROSS)
    points = np.array(on_mat(x, y, facing, hits))
    columns, rows = np.floor(points / CELL).astype(int).T
    inside = (columns >= 0) & (columns < ACROSS) & (rows >= 0) & (rows < ACROSS)
    return grid[rows[inside], columns[inside]].sum() / len(hits)


def match(field, x, y, facing, hits):
    poses = [(x + dx, y + dy, facing + turn) for turn in TURNS for dx in SHIFTS for dy in SHIFTS]
    fits = [fit(field, *pose, hits) for pose in poses]
    return poses[int(np.argmax(fits))]
