# style: NumPy: all points against all walls
import numpy as np


def straight_way(start, goal, walls):
    if not walls:
        return True
    count = int(np.ceil(dist(start, goal))) + 2
    points = np.linspace(start, goal, count)
    middles = (np.array(list(walls)) + 0.5) * CELL
    gaps = np.linalg.norm(points[:, None, :] - middles[None, :, :], axis=2) - CELL / 2
    return (gaps >= SPARE).all()
