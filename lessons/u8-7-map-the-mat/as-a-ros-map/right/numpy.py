# style: NumPy: where() on the log odds, and flipud
import numpy as np


def image_rows(log_odds, across):
    limit = math.log(0.65 / 0.35)
    grid = np.reshape(log_odds, (across, across))
    return np.flipud(np.where(grid > limit, 0, np.where(grid < -limit, 254, 205)))


def settings(image, cell_cm):
    names = ["image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"]
    return dict(zip(names, [image, round(cell_cm / 100, 4), (0.0, 0.0, 0.0), 0, 0.65, 0.19]))
