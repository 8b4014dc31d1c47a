# style: NumPy: the way in the robot's own axes
import numpy as np


def speeds(dx, dy, facing):
    way = np.array([dx, dy], float)
    length = np.linalg.norm(way)
    if length == 0:
        return np.zeros(2)
    angle = np.radians(facing)
    axes = np.array([[np.sin(angle), np.cos(angle)], [np.cos(angle), -np.sin(angle)]])
    return axes @ way * 100 / length
