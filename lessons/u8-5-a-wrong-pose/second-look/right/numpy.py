# style: NumPy: the main axis of the points' covariance
import numpy as np


def wall_direction(looks):
    seen = [(facing + angle, r) for facing, readings in looks for angle, r in readings if r < FAR]
    way, reading = np.array(seen, float).T
    points = np.stack([reading * np.sin(np.radians(way)), reading * np.cos(np.radians(way))])
    values, vectors = np.linalg.eigh(np.cov(points))
    x, y = vectors[:, np.argmax(values)]
    return np.degrees(np.arctan2(x, y)) % 180


def drift_rate(first, second, seconds):
    turned = wall_direction(second) - wall_direction(first)
    while turned > 90:
        turned -= 180
    while turned < -90:
        turned += 180
    return turned / seconds
