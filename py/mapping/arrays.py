"""The same grid as a NumPy array: whole beams and whole maps in one expression.

May import: NumPy, the standard library, `bugbot.frames`, the rest of `mapping`. No other module
of ours imports NumPy, and the rest of `mapping` does not import this one.

Here the grid has two dimensions, `cells[row, column]`, still with row 0 at the bottom:
the array that `reshape(across, across)` makes of the flat list. Every result equals
that of the lists, to the last bit.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from bugbot.frames import direction
from mapping.beam import Weights, clear_length, end_of_hit
from mapping.frontiers import State
from mapping.grid import Grid

__all__ = ["ArrayMapper", "frontier_mask", "three_states"]


class ArrayMapper:
    """`mapping.mapper.Mapper` on an array, by half-cell steps.

    cells  log odds, indexed [row, column]

    >>> mapper = ArrayMapper(50)
    >>> mapper.add_scan(25, 25, 0, [(0, 130)])
    >>> mapper.cells[:, 0].tolist()
    [-0.4, -0.8, 0.0, 0.85]
    """

    def __init__(
        self,
        cell_cm: float = 5.0,
        weights: Weights = Weights(),  # noqa: B008 - it is frozen
    ) -> None:
        self.grid = Grid(cell_cm)
        self.weights = weights
        self.cells: NDArray[np.float64] = np.zeros((self.grid.across, self.grid.across))

    def add_scan(
        self, x: float, y: float, heading_deg: float, scan: Iterable[tuple[float, float]]
    ) -> None:
        """As `Mapper.add_scan`."""
        for angle_deg, reading_cm in scan:
            self.add_beam(x, y, heading_deg + angle_deg, reading_cm)

    def add_beam(self, x: float, y: float, angle_deg: float, reading_cm: float) -> None:
        """As `Mapper.add_beam`, all steps of the beam at once."""
        weights, cell_cm = self.weights, self.grid.cell_cm
        dx, dy = direction(angle_deg)
        step = cell_cm / 2
        clear_cm = clear_length(reading_cm, cell_cm, weights.far_cm)
        along = np.arange(int(clear_cm / step)) * step
        columns = np.floor((x + along * dx) / cell_cm).astype(np.int64)
        rows = np.floor((y + along * dy) / cell_cm).astype(np.int64)
        across = self.grid.across
        on_mat = (columns >= 0) & (columns < across) & (rows >= 0) & (rows < across)
        # `cells[rows, columns] += …` would count a cell named twice only once.
        np.add.at(self.cells, (rows[on_mat], columns[on_mat]), weights.l_free)
        self._clamp()
        end = end_of_hit(x, y, angle_deg, reading_cm, weights.far_cm)
        index = None if end is None else self.grid.index_at(*end)
        if index is not None:
            self.cells.flat[index] += weights.l_occ
            self._clamp()

    def _clamp(self) -> None:
        np.clip(self.cells, -self.weights.l_max, self.weights.l_max, out=self.cells)


def three_states(
    cells: NDArray[np.float64], free_below: float, occupied_above: float
) -> NDArray[np.int8]:
    """As `mapping.frontiers.three_states`: an array of `State` values.

    >>> three_states(np.array([[-2.0, 0.0, 2.0]]), -1, 1).tolist()
    [[0, -1, 100]]
    """
    states = np.full(cells.shape, State.UNKNOWN, dtype=np.int8)
    states[cells < free_below] = State.FREE
    states[cells > occupied_above] = State.OCCUPIED
    return states


def frontier_mask(states: NDArray[np.int8]) -> NDArray[np.bool_]:
    """Where a free cell has an unknown one at a side: `frontier_cells` as an array of booleans.

    >>> frontier_mask(np.array([[0, -1, 0], [0, 100, 0]])).tolist()
    [[True, False, True], [False, False, False]]
    """
    free: NDArray[np.bool_] = states == State.FREE
    unknown: NDArray[np.bool_] = states == State.UNKNOWN
    beside = np.zeros_like(unknown)
    beside[1:] |= unknown[:-1]  # the cell below is unknown, and so on round
    beside[:-1] |= unknown[1:]
    beside[:, 1:] |= unknown[:, :-1]
    beside[:, :-1] |= unknown[:, 1:]
    return free & beside
