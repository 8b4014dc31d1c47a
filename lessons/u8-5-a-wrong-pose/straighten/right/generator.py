# style: a named tuple, itertools and a pair of turning functions
from collections import namedtuple
from itertools import accumulate

Pose = namedtuple("Pose", "x y facing")


def swung(dx, dy, degrees):
    """A step on the mat, turned to the left."""
    s, c = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
    return dx * c - dy * s, dx * s + dy * c


def corrected(looks, rate):
    steps = [(looks[0][1], looks[0][2])]
    for (_, x0, y0, *_), (t, x1, y1, *_) in zip(looks, looks[1:]):
        steps.append(swung(x1 - x0, y1 - y0, rate * t))
    places = accumulate(steps, lambda a, b: (a[0] + b[0], a[1] + b[1]))
    return [Pose(x, y, look[3] - rate * look[0]) for (x, y), look in zip(places, looks)]
