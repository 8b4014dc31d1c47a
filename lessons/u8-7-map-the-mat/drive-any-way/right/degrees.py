# style: degrees all through, and a named tuple
from typing import NamedTuple


class Speeds(NamedTuple):
    forward: float
    right: float


def bearing(dx, dy):
    """The direction of a way in degrees, clockwise from straight up the mat."""
    return (90 - math.degrees(math.atan2(dy, dx))) % 360


def speeds(dx, dy, facing):
    if (dx, dy) == (0, 0):
        return Speeds(0, 0)
    off = (bearing(dx, dy) - facing + 180) % 360 - 180
    return Speeds(100 * math.cos(math.radians(off)), 100 * math.sin(math.radians(off)))
