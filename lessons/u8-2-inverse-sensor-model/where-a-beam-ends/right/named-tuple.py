# style: a named tuple

from typing import NamedTuple


class Point(NamedTuple):
    x: float
    y: float


a = math.tau * angle / 360
return Point(x + math.sin(a) * reading, y + math.cos(a) * reading)
