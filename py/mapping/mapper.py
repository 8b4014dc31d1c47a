"""A grid that takes scans: the whole of occupancy grid mapping with known poses.

May import: the standard library, `mapping.grid`, `mapping.log_odds`, `mapping.beam`.

This is the algorithm of "Probabilistic Robotics" 9.2, table 9.1: for each reading, add the
inverse sensor model's log odds to the cells it speaks of. Cells it says nothing about
keep what they have.
"""

from __future__ import annotations

from collections.abc import Iterable

from mapping.beam import PassedBy, Weights, clear_length, end_of_hit, passed_by_steps
from mapping.grid import Grid
from mapping.log_odds import clamped

__all__ = ["Mapper"]


class Mapper:
    """An occupancy grid and the evidence it weighs readings with.

    cell_cm    side of a cell [cm], 1 to 200
    weights    how much a hit and a pass count, the clamp, and what is no hit
    passed_by  how the cells that a beam passed are listed: `passed_by_steps` or
               `passed_by_bresenham` of `mapping.beam`

    >>> mapper = Mapper(50)
    >>> mapper.add_scan(25, 25, 0, [(0, 130)])
    >>> [round(l, 2) for l in mapper.grid.cells if l]
    [-0.4, -0.8, 0.85]
    """

    def __init__(
        self,
        cell_cm: float = 5.0,
        weights: Weights = Weights(),  # noqa: B008 - it is frozen
        passed_by: PassedBy = passed_by_steps,
    ) -> None:
        self.grid = Grid(cell_cm)
        self.weights = weights
        self._passed_by = passed_by

    def add_scan(
        self, x: float, y: float, heading_deg: float, scan: Iterable[tuple[float, float]]
    ) -> None:
        """Add a scan taken at (x, y) on the mat [cm], facing `heading_deg`.

        scan  pairs (angle from straight ahead [degrees], distance [cm]) as `scan()` gives them
        """
        for angle_deg, reading_cm in scan:
            self.add_beam(x, y, heading_deg + angle_deg, reading_cm)

    def add_beam(self, x: float, y: float, angle_deg: float, reading_cm: float) -> None:
        """Add one reading of a beam from (x, y) [cm] at an angle clockwise from up the mat.

        First free floor, then the hit, each clamped as it is added. Cells beyond the mat
        are no cells: a wrong pose may well see walls out there. Raises WrongValueError for
        a reading that is negative or not a number.
        """
        grid = self.grid
        clear_cm = clear_length(reading_cm, grid.cell_cm, self.weights.far_cm)
        for cell in self._passed_by(x, y, angle_deg, clear_cm, grid.cell_cm):
            if grid.holds(cell):
                self._add(grid.index(cell), self.weights.l_free)
        end = end_of_hit(x, y, angle_deg, reading_cm, self.weights.far_cm)
        if end is not None:
            index = grid.index_at(*end)
            if index is not None:
                self._add(index, self.weights.l_occ)

    def _add(self, index: int, evidence: float) -> None:
        cells = self.grid.cells
        cells[index] = clamped(cells[index] + evidence, self.weights.l_max)
