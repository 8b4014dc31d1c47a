"""The mat as a grid of cells, kept as one flat list.

May import: the standard library, `bugbot.frames`, `bugbot.errors`.

The idea of keeping a number per small square of floor is Moravec and Elfes's (1985).
"""

from __future__ import annotations

from bugbot.errors import WrongValueError, got
from bugbot.frames import MAT_CM, cell_centre, cell_of, cells_across

__all__ = ["MIN_CELL_CM", "Cell", "Grid", "Point"]

Point = tuple[float, float]
"""(x, y) on the mat [cm]."""

Cell = tuple[int, int]
"""(column, row), counted from the lower left corner; may lie beyond the mat."""

MIN_CELL_CM = 1.0
"""The smallest cell worth having: half of the sensor's own noise [cm]."""


class Grid:
    """One number for each cell of the mat, all 0 at first.

    cell_cm  side of a cell [cm], 1 to 200; cells that don't fit hang over the far edges
    across   how many cells make a row, and a column
    cells    the numbers (log odds), row after row from the bottom

    >>> grid = Grid(5)
    >>> grid.across, len(grid.cells), grid.index_at(102.5, 7)
    (40, 1600, 60)
    """

    def __init__(self, cell_cm: float) -> None:
        if not MIN_CELL_CM <= cell_cm <= MAT_CM:  # False for NaN too
            raise WrongValueError(
                f"Grid(cell_cm) wants a number from {MIN_CELL_CM:g} to {MAT_CM:g} (cm); "
                f"it got {got(cell_cm)}"
            )
        self.cell_cm = float(cell_cm)
        self.across = cells_across(self.cell_cm)
        self.cells = [0.0] * (self.across * self.across)

    def holds(self, cell: Cell) -> bool:
        """Whether a (column, row) lies on the mat."""
        column, row = cell
        return 0 <= column < self.across and 0 <= row < self.across

    def index(self, cell: Cell) -> int:
        """Place of a (column, row) in the flat list.

        Raises WrongValueError beyond the mat: without that check the column after the
        last would quietly mean the first column of the next row.
        """
        if not self.holds(cell):
            raise WrongValueError(
                f"index(cell) wants a column and a row from 0 to {self.across - 1}; "
                f"it got {got(cell)}"
            )
        return cell[1] * self.across + cell[0]

    def cell(self, index: int) -> Cell:
        """The (column, row) at a place in the flat list; WrongValueError if there is none."""
        if not 0 <= index < len(self.cells):
            raise WrongValueError(
                f"cell(index) wants a number from 0 to {len(self.cells) - 1}; it got {got(index)}"
            )
        return index % self.across, index // self.across

    def index_at(self, x: float, y: float) -> int | None:
        """Place in the flat list of the cell that holds a point [cm]; None beyond the mat."""
        cell = cell_of(x, y, self.cell_cm)
        if cell is None:
            return None
        # With cells a rounding error short of a divisor of 200 (1.99999999999997 cm), the last
        # sliver of the mat belongs to the last cell; it must not wrap into the next row.
        last = self.across - 1
        return self.index((min(cell[0], last), min(cell[1], last)))

    def centre(self, index: int) -> Point:
        """Middle of the cell at a place in the flat list [cm].

        >>> Grid(5).centre(60)
        (102.5, 7.5)
        """
        return cell_centre(*self.cell(index), self.cell_cm)

    def beside(self, index: int) -> list[int]:
        """The cells that share a side with this one: two in a corner, up to four.

        >>> Grid(100).beside(0)
        [1, 2]
        """
        column, row = self.cell(index)
        around = ((column - 1, row), (column + 1, row), (column, row - 1), (column, row + 1))
        return [self.index(each) for each in around if self.holds(each)]

    def around(self, index: int) -> list[int]:
        """The cells that share a side or a corner with this one: three in a corner, up to eight.

        >>> Grid(100).around(0)
        [1, 2, 3]
        """
        column, row = self.cell(index)
        near = (-1, 0, 1)
        cells = ((column + c, row + r) for r in near for c in near if (c, r) != (0, 0))
        return [self.index(each) for each in cells if self.holds(each)]
