# style: a search for the direction with the smallest spread across it
from statistics import pvariance


def points_of(looks):
    for facing, readings in looks:
        for angle, reading in readings:
            if reading < FAR:
                way = math.radians(facing + angle)
                yield reading * math.sin(way), reading * math.cos(way)


def wall_direction(looks):
    points = list(points_of(looks))

    def spread(degrees):
        s, c = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
        return pvariance([x * c - y * s for x, y in points])

    best, step = min(range(0, 180, 5), key=spread), 5
    while step > 0.0005:
        step /= 2
        best = min((best - step, best, best + step), key=spread)
    return best % 180


def drift_rate(first, second, seconds):
    turned = wall_direction(second) - wall_direction(first)
    return min((turned - 180, turned, turned + 180), key=abs) / seconds
