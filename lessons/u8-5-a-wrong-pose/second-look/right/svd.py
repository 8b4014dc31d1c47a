# style: singular values, in a class for lines
import numpy as np


class Line:
    def __init__(self, looks):
        xs, ys = [], []
        for facing, readings in looks:
            for angle, distance in readings:
                if distance >= FAR:
                    continue
                xs.append(distance * math.sin(math.radians(facing + angle)))
                ys.append(distance * math.cos(math.radians(facing + angle)))
        points = np.column_stack([xs, ys])
        self.along = np.linalg.svd(points - points.mean(axis=0))[2][0]

    def direction(self):
        return float(np.rad2deg(np.arctan2(self.along[0], self.along[1])) % 180)


def wall_direction(looks):
    return Line(looks).direction()


def drift_rate(first, second, seconds):
    a = Line(first).along
    b = Line(second).along
    if a @ b < 0:
        b = -b
    turned = math.asin(b[0] * a[1] - b[1] * a[0])
    return math.degrees(turned) / seconds
