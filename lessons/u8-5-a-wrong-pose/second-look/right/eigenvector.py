# style: statistics and the larger eigenvalue, with a generator of the hits
from statistics import fmean, pvariance


def hits(looks):
    for facing, readings in looks:
        for angle, reading in readings:
            if reading < FAR:
                yield facing + angle, reading


def wall_direction(looks):
    xs = [r * math.sin(math.radians(w)) for w, r in hits(looks)]
    ys = [r * math.cos(math.radians(w)) for w, r in hits(looks)]
    a, c = pvariance(xs), pvariance(ys)
    b = fmean(x * y for x, y in zip(xs, ys)) - fmean(xs) * fmean(ys)
    largest = (a + c) / 2 + math.hypot((a - c) / 2, b)
    # Two ways to write the same vector; the longer one is never (0, 0).
    vector = max((b, largest - a), (largest - c, b), key=lambda v: math.hypot(*v))
    return math.degrees(math.atan2(*vector)) % 180


def drift_rate(first, second, seconds):
    old, new = map(wall_direction, (first, second))
    return min((new - old + k for k in (-180, 0, 180)), key=abs) / seconds
