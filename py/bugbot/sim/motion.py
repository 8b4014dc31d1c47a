"""How the robot moves: its speeds, and where a moving circle first touches something.

May import: the standard library, `bugbot.frames`, the rest of `bugbot.sim`.

The robot is a circle of 5 cm radius. It stops dead where it first touches a
rectangle or the wall round the mat; from there it may turn, move away, or move
exactly along what it touches, and nothing else.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import hypot, sqrt

from bugbot.frames import MAT_CM, ROBOT_RADIUS_CM
from bugbot.sim.world import Box

__all__ = ["SPEED_CM_S", "SPIN_DEG_S", "Touch", "first_touch", "speeds"]

SPEED_CM_S = 11.5
"""Speed along the floor at 100 per cent, ahead and sideways alike [cm/s]."""

SPIN_DEG_S = 120.0
"""Turning speed at 100 per cent [degrees/s]."""

_SKIN_CM = 1e-7
"""Nearer than this is touching: positions are kept to 1e-9 cm, so contact is never exact."""

_ALONG_CM = 4e-10
"""A step that comes nearer by less than this is a step along: rounding takes it away again."""

Touch = tuple[float, float, float]
"""How much of a step can be done, 0 to 1, and the point (x, y) touched then [cm]."""


def speeds(forward: float, right: float, turn: float) -> tuple[float, float, float]:
    """Per cents, clamped to -100 to 100, as cm/s ahead, cm/s to the right, degrees/s clockwise.

    >>> speeds(50, -200, 25)
    (5.75, -11.5, 30.0)
    """
    ahead, aside, spin = (max(-100.0, min(100.0, each)) / 100.0 for each in (forward, right, turn))
    return ahead * SPEED_CM_S, aside * SPEED_CM_S, spin * SPIN_DEG_S


def first_touch(boxes: Iterable[Box], x: float, y: float, dx: float, dy: float) -> Touch | None:
    """What stops the robot at (x, y) when it moves by (dx, dy) [cm], or None if nothing does."""
    best = _edge(x, y, dx, dy)
    reach = ROBOT_RADIUS_CM + _SKIN_CM + abs(dx) + abs(dy)
    for box in boxes:
        left, low, right, high = box
        if x < left - reach or x > right + reach or y < low - reach or y > high + reach:
            continue
        share = _share(box, x, y, dx, dy)
        if share is not None and (best is None or share < best[0]):
            best = (share, *_nearest(box, x + share * dx, y + share * dy))
    return best


def _edge(x: float, y: float, dx: float, dy: float) -> Touch | None:
    """The first touch of the wall round the mat."""
    best: Touch | None = None
    far = MAT_CM - ROBOT_RADIUS_CM
    room_x = far - x if dx > 0 else x - ROBOT_RADIUS_CM
    if abs(dx) > _ALONG_CM and abs(dx) > room_x:
        share = max(0.0, room_x / abs(dx))
        best = (share, MAT_CM if dx > 0 else 0.0, y + share * dy)
    room_y = far - y if dy > 0 else y - ROBOT_RADIUS_CM
    if abs(dy) > _ALONG_CM and abs(dy) > room_y:
        share = max(0.0, room_y / abs(dy))
        if best is None or share < best[0]:
            best = (share, x + share * dx, MAT_CM if dy > 0 else 0.0)
    return best


def _nearest(box: Box, x: float, y: float) -> tuple[float, float]:
    """The point of a box that is nearest to (x, y)."""
    left, low, right, high = box
    return max(left, min(right, x)), max(low, min(high, y))


def _share(box: Box, x: float, y: float, dx: float, dy: float) -> float | None:
    """The share of a step after which the robot touches this box, or None."""
    near_x, near_y = _nearest(box, x, y)
    away_x, away_y = near_x - x, near_y - y
    gap = hypot(away_x, away_y)
    if gap <= ROBOT_RADIUS_CM + _SKIN_CM:
        # Touching already. The box is convex: a step that does not come nearer at once never will.
        return 0.0 if dx * away_x + dy * away_y > _ALONG_CM * gap else None
    # The centre must stay out of the box grown by the radius, whose corners are round.
    left, low, right, high = box
    enter, leave = 0.0, 1.0
    grown_x = (left - ROBOT_RADIUS_CM - x, right + ROBOT_RADIUS_CM - x, dx)
    grown_y = (low - ROBOT_RADIUS_CM - y, high + ROBOT_RADIUS_CM - y, dy)
    for lower, upper, step in (grown_x, grown_y):
        if step == 0:
            if not lower < 0 < upper:
                return None
            continue
        first, last = lower / step, upper / step
        enter = max(enter, min(first, last))
        leave = min(leave, max(first, last))
    if enter > leave:
        return None
    at_x, at_y = x + enter * dx, y + enter * dy
    if left <= at_x <= right or low <= at_y <= high:
        return enter
    return _corner_share(
        x - (left if at_x < left else right), y - (low if at_y < low else high), dx, dy
    )


def _corner_share(from_x: float, from_y: float, dx: float, dy: float) -> float | None:
    """The share of a step after which a centre, seen from a corner, is one radius from it."""
    # |from + s d| = radius, a quadratic in s; the centre starts outside.
    a = dx * dx + dy * dy
    b = from_x * dx + from_y * dy
    c = from_x * from_x + from_y * from_y - ROBOT_RADIUS_CM * ROBOT_RADIUS_CM
    discriminant = b * b - a * c
    if b >= 0 or discriminant < 0:
        return None
    share = (-b - sqrt(discriminant)) / a
    return share if share <= 1 else None
