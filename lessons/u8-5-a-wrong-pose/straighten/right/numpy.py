# style: NumPy: all steps turned at once and summed
import numpy as np


def corrected(looks, rate):
    t, x, y, facing = np.array([look[:4] for look in looks], dtype=float).T
    turned = np.deg2rad(rate * t)
    dx, dy = np.diff(x, prepend=x[0]), np.diff(y, prepend=y[0])
    xs = x[0] + np.cumsum(dx * np.cos(turned) - dy * np.sin(turned))
    ys = y[0] + np.cumsum(dy * np.cos(turned) + dx * np.sin(turned))
    return np.column_stack([xs, ys, facing - rate * t])
