"""The depth sensor: eight beams over 45 degrees, and the rays behind them.

May import: the standard library, `bugbot.frames`, the rest of `bugbot.sim`.

Rays begin at the robot's centre and end at the first solid, an obstacle or the
wall round the mat. Solids include their edges: a ray that only grazes one ends
there.

A ray's direction is the robot's heading turned by the beam's angle, by plain
arithmetic with sines and cosines that are rounded first (see `rounding.py`).
"""

from __future__ import annotations

from collections.abc import Iterable
from math import inf
from random import Random

from bugbot.frames import MAT_CM, direction
from bugbot.sim.noise import DEPTH_SD_CM
from bugbot.sim.rounding import unit
from bugbot.sim.world import Box

__all__ = [
    "AHEAD",
    "ANGLES_DEG",
    "BEAMS",
    "RANGE_CM",
    "Beam",
    "distances",
    "exact_direction",
    "read",
]

RANGE_CM = 200.0
"""The farthest the sensor sees, and what it reads when it finds nothing [cm]."""

ANGLES_DEG = tuple(-19.6875 + 5.625 * column for column in range(8))
"""Angles of the beams from straight ahead, left to right [degrees, clockwise positive]."""

Beam = tuple[float, float, float]
"""A beam's angle [degrees] with its sine and cosine."""


def exact_direction(heading_deg: float) -> tuple[float, float]:
    """Unit vector (x, y) of a heading, the same to the last bit on every engine.

    >>> exact_direction(90)
    (1.0, 0.0)
    """
    x, y = direction(heading_deg)
    return unit(x), unit(y)


def _beam(angle: float) -> Beam:
    return (angle, *exact_direction(angle))


BEAMS: tuple[Beam, ...] = tuple(_beam(angle) for angle in ANGLES_DEG)
AHEAD: tuple[Beam, ...] = (_beam(0.0),)


def distances(
    boxes: Iterable[Box], x: float, y: float, heading_deg: float, beams: Iterable[Beam]
) -> list[float]:
    """True distance [cm] from (x, y), on the mat, along each beam to the first solid."""
    sin_h, cos_h = exact_direction(heading_deg)
    # Seen from the ray's origin, so that each ray needs only divisions.
    around = [(left - x, low - y, right - x, high - y) for left, low, right, high in boxes]
    to_left, to_right, to_low, to_high = -x, MAT_CM - x, -y, MAT_CM - y
    found = []
    for _, sin_b, cos_b in beams:
        dx = sin_h * cos_b + cos_h * sin_b
        dy = cos_h * cos_b - sin_h * sin_b
        across = to_right / dx if dx > 0 else to_left / dx if dx < 0 else inf
        along = to_high / dy if dy > 0 else to_low / dy if dy < 0 else inf
        nearest = across if across < along else along
        for left, low, right, high in around:
            # The ray is between the box's sides from `enter` to `leave`, first by x, then by y.
            if dx > 0:
                if right < 0:
                    continue
                enter, leave = left / dx, right / dx
            elif dx < 0:
                if left > 0:
                    continue
                enter, leave = right / dx, left / dx
            elif left <= 0 <= right:
                enter, leave = -inf, inf
            else:
                continue
            if dy > 0:
                enter_y, leave_y = low / dy, high / dy
            elif dy < 0:
                enter_y, leave_y = high / dy, low / dy
            elif low <= 0 <= high:
                enter_y, leave_y = -inf, inf
            else:
                continue
            if enter_y > enter:
                enter = enter_y
            if leave_y < leave:
                leave = leave_y
            if enter <= leave and leave >= 0 and enter < nearest:
                nearest = enter if enter > 0 else 0.0
        found.append(nearest)
    return found


def read(true_cm: float, chance: Random) -> float:
    """What the sensor says of a true distance [cm]: noisy, 0 to 200, in whole millimetres."""
    if true_cm > RANGE_CM:
        return RANGE_CM
    noisy = true_cm + chance.normalvariate(0.0, DEPTH_SD_CM)
    return round(min(RANGE_CM, max(0.0, noisy)) * 10.0) / 10.0
