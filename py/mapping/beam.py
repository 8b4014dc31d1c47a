"""The inverse sensor model: from one reading to evidence about cells.

May import: the standard library, `bugbot.frames`, `bugbot.errors`, `mapping.grid`,
`mapping.log_odds`.

A beam says two things: the floor is free up to where it ended, and something stands
there (Moravec and Elfes 1985; "inverse" because it goes from a reading to the map,
"Probabilistic Robotics" 9.2). Two rules keep it honest:

* It speaks for free floor only up to one cell short of the hit, since noise may
  have put the hit a little too far.
* A reading of FAR_CM or more marks no hit: the sensor's largest reading means that
  nothing was found. It is believed as free floor up to FAR_CM.

There are two ways to list the cells it passed:

`passed_by_steps` walks along the beam in steps of half a cell and names the cell at each
step. Whole cells would jump over corners and leave speckles. A cell that is crossed in
full is named about twice and so gets its evidence twice; the mapper counts on that:
the floor ahead falls by 2 * 0.4 at each look.

`passed_by_bresenham` draws a line of cells with whole numbers only (Bresenham 1965),
each cell once. The line has no gaps, not even at corners it turns round diagonally,
but it is one cell thick: a corner that the beam clips between two of them is left out.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import floor

from bugbot.errors import WrongValueError, got
from bugbot.frames import direction
from mapping.grid import Cell, Point
from mapping.log_odds import L_FREE, L_MAX, L_OCC

__all__ = [
    "FAR_CM",
    "PassedBy",
    "Weights",
    "bresenham",
    "clear_length",
    "end_of_beam",
    "end_of_hit",
    "passed_by_bresenham",
    "passed_by_steps",
]

FAR_CM = 170.0
"""A reading this long or longer is not a wall [cm]."""

PassedBy = Callable[[float, float, float, float, float], list[Cell]]
"""passed_by(x, y, angle_deg, length_cm, cell_cm): the cells a beam passed, some perhaps
beyond the mat, some perhaps more than once."""


@dataclass(frozen=True, slots=True)
class Weights:
    """How much a reading is believed; WrongValueError if the numbers make no sense.

    l_occ   log odds added to the cell where a beam ended, 0 or more
    l_free  log odds added to a cell for each time a beam passed it, 0 or less
    l_max   log odds stay between -l_max and l_max, above 0
    far_cm  a reading this long or longer is no hit [cm], above 0
    """

    l_occ: float = L_OCC
    l_free: float = L_FREE
    l_max: float = L_MAX
    far_cm: float = FAR_CM

    def __post_init__(self) -> None:
        if not (self.l_free <= 0.0 <= self.l_occ and self.l_max > 0.0 and self.far_cm > 0.0):
            raise WrongValueError(
                "Weights wants l_occ of 0 or more, l_free of 0 or less, l_max and far_cm above 0; "
                f"it got {self}"
            )


def end_of_beam(x: float, y: float, angle_deg: float, length_cm: float) -> Point:
    """The point a length [cm] away at an angle [degrees clockwise from up the mat].

    >>> end_of_beam(100, 50, 0, 30)
    (100.0, 80.0)
    """
    dx, dy = direction(angle_deg)
    return x + length_cm * dx, y + length_cm * dy


def clear_length(reading_cm: float, cell_cm: float, far_cm: float = FAR_CM) -> float:
    """How far along its beam a reading speaks for free floor [cm]; 0 if nowhere.

    Raises WrongValueError for a reading that is negative or not a number.

    >>> clear_length(50.0, 5), clear_length(200.0, 5), clear_length(3.0, 5)
    (45.0, 170.0, 0.0)
    """
    if not reading_cm >= 0.0:  # False for NaN too
        raise WrongValueError(
            f"a reading wants a number of 0 or more (cm); it got {got(reading_cm)}"
        )
    if reading_cm >= far_cm:
        return far_cm
    return max(0.0, reading_cm - cell_cm)


def end_of_hit(
    x: float, y: float, angle_deg: float, reading_cm: float, far_cm: float = FAR_CM
) -> Point | None:
    """Where the reading says that something stands [cm]; None for a reading of nothing.

    The point may lie beyond the mat: noise carries readings of the mat's own walls there.
    """
    return end_of_beam(x, y, angle_deg, reading_cm) if reading_cm < far_cm else None


def passed_by_steps(
    x: float, y: float, angle_deg: float, length_cm: float, cell_cm: float
) -> list[Cell]:
    """The cell at each half-cell step from (x, y), for all the whole steps in the length.

    >>> passed_by_steps(7.5, 2.5, 0, 10, 5)
    [(1, 0), (1, 1), (1, 1), (1, 2)]
    """
    dx, dy = direction(angle_deg)
    step = cell_cm / 2
    return [
        (floor((x + i * step * dx) / cell_cm), floor((y + i * step * dy) / cell_cm))
        for i in range(int(length_cm / step))
    ]


def passed_by_bresenham(
    x: float, y: float, angle_deg: float, length_cm: float, cell_cm: float
) -> list[Cell]:
    """A line of cells from the one that holds (x, y) to the one at the length, each once.

    >>> passed_by_bresenham(7.5, 2.5, 0, 10, 5)
    [(1, 0), (1, 1), (1, 2)]
    """
    end_x, end_y = end_of_beam(x, y, angle_deg, length_cm)
    return bresenham(
        (floor(x / cell_cm), floor(y / cell_cm)), (floor(end_x / cell_cm), floor(end_y / cell_cm))
    )


def bresenham(first: Cell, last: Cell) -> list[Cell]:
    """The cells of a line between two cells, both included (Bresenham 1965).

    Each step goes one cell along the longer side, and sideways too whenever the true line
    has drifted by more than half a cell from the row or column it is in. `drift` measures
    what is left of that half cell, times twice the longer side, so that it stays whole.

    >>> bresenham((0, 0), (4, 2))
    [(0, 0), (1, 0), (2, 1), (3, 1), (4, 2)]
    """
    column, row = first
    wide, high = abs(last[0] - column), abs(last[1] - row)
    right = 1 if last[0] >= column else -1
    up = 1 if last[1] >= row else -1
    longer, shorter = max(wide, high), min(wide, high)
    line = [first]
    drift = longer
    for _ in range(longer):
        drift -= 2 * shorter
        sideways = drift < 0
        if sideways:
            drift += 2 * longer
        if wide >= high or sideways:
            column += right
        if wide < high or sideways:
            row += up
        line.append((column, row))
    return line
