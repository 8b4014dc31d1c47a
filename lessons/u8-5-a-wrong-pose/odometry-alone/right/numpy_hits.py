# style: NumPy, all hits of a rate at once
import numpy as np


def corrected(looks, rate):
    """The poses of the looks without the drift: (x, y, facing)."""
    times = np.array([look[0] for look in looks])
    xs, ys, facings = np.array([look[1:4] for look in looks]).T
    turned = np.radians(rate * times[1:])
    dx, dy = np.diff(xs), np.diff(ys)
    way_x = np.concatenate([[0], np.cumsum(dx * np.cos(turned) - dy * np.sin(turned))])
    way_y = np.concatenate([[0], np.cumsum(dy * np.cos(turned) + dx * np.sin(turned))])
    return np.column_stack([xs[0] + way_x, ys[0] + way_y, facings - rate * times]).tolist()


def sharpness(looks, rate):
    poses = np.array(corrected(looks, rate))
    scans = np.array([look[4] for look in looks])
    ways = np.radians(poses[:, 2:3] + scans[:, :, 0])
    far = scans[:, :, 1]
    columns = np.floor((START[0] + poses[:, 0:1] + far * np.sin(ways)) / CELL)
    rows = np.floor((START[1] + poses[:, 1:2] + far * np.cos(ways)) / CELL)
    keys = (rows * 1000 + columns)[far < FAR]
    return -np.unique(keys).size


def find_rate(looks):
    """How fast the believed heading drifts, in degrees/s."""
    return float(max(np.arange(-0.45, 0.451, 0.01), key=lambda rate: sharpness(looks, rate)))
