"""The conventions of the mat, written once: units, axes, heading and cells.

May import: the standard library only.

* Lengths are in centimetres, angles in degrees, time in seconds.
* x runs to the right, y runs up the mat, the origin is the lower left corner.
* A heading is measured clockwise from straight up the mat, like a compass, so
  the direction of heading h is (sin h, cos h): sine for x, cosine for y.
* A cell is (column, row) counted from the lower left corner. A point on the
  line between two cells belongs to the upper or right one (floor). A point
  beyond the mat has no cell.
"""

from __future__ import annotations

from math import cos, floor, radians, sin

__all__ = [
    "MAT_CM",
    "ROBOT_RADIUS_CM",
    "cell_centre",
    "cell_of",
    "cells_across",
    "direction",
    "turn_between",
    "wrap_heading",
]

MAT_CM = 200.0
"""Side of the square mat [cm]."""

ROBOT_RADIUS_CM = 5.0
"""Radius of the round robot [cm]."""


def direction(heading_deg: float) -> tuple[float, float]:
    """Unit vector (x, y) of a heading [degrees clockwise from up the mat].

    >>> direction(0)
    (0.0, 1.0)
    """
    angle = radians(heading_deg)
    return sin(angle), cos(angle)


def wrap_heading(heading_deg: float) -> float:
    """The same heading as a number from 0 (included) to 360 (excluded).

    >>> wrap_heading(-90)
    270.0
    """
    wrapped = float(heading_deg) % 360.0
    # -1e-20 % 360 is 360.0 after rounding, which is not below 360.
    return 0.0 if wrapped >= 360.0 else wrapped


def turn_between(from_deg: float, to_deg: float) -> float:
    """Shortest turn between two headings, from -180 (excluded) to 180, clockwise positive.

    >>> turn_between(350, 10)
    20.0
    """
    turn = (float(to_deg) - float(from_deg)) % 360.0
    return turn - 360.0 if turn > 180.0 else turn


def cells_across(cell_cm: float, side_cm: float = MAT_CM) -> int:
    """How many cells of side `cell_cm` cover a side; the last may hang over the edge.

    >>> cells_across(5), cells_across(30)
    (40, 7)
    """
    whole = int(side_cm // cell_cm)
    return whole if whole * cell_cm >= side_cm - 1e-9 else whole + 1


def cell_of(x: float, y: float, cell_cm: float) -> tuple[int, int] | None:
    """The (column, row) that holds point (x, y) [cm], or None beyond the mat.

    The far edges x = 200 and y = 200 are beyond the mat.

    >>> cell_of(102.5, 7, 5)
    (20, 1)
    """
    if not (0.0 <= x < MAT_CM and 0.0 <= y < MAT_CM):
        return None
    return floor(x / cell_cm), floor(y / cell_cm)


def cell_centre(column: int, row: int, cell_cm: float) -> tuple[float, float]:
    """Centre (x, y) [cm] of a cell.

    >>> cell_centre(20, 1, 5)
    (102.5, 7.5)
    """
    return (column + 0.5) * cell_cm, (row + 0.5) * cell_cm
