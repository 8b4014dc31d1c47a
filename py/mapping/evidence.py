"""What the beams of a run say of each cell, whichever sound rule they are added up by.

May import: the standard library, `bugbot.frames`, `mapping.beam`, `mapping.frontiers`,
`mapping.grid`, `mapping.log_odds`.

There is more than one sound way to turn a beam into cells: steps of half a cell, each crossed cell
once, Bresenham's line, a cone. So a map can't be marked by its likeness to one of them.
Here each beam is followed exactly from cell to cell (Amanatides and Woo, "A Fast Voxel Traversal
Algorithm", 1987), and log odds are added up in three ways at once, with the lessons' weights:

* steps of half a cell, up to one cell short of the hit: the lessons' own rule;
* each cell once, up to one cell short of the hit;
* each cell once, up to the hit, whose own cell is left out.

The other rules lie between these, give or take a cell at the side of a beam. So a cell is

* *supported* if one of the three says of it what the map says;
* *backed* if, for a free cell, all three say so: what is painted free, though the mapper's own sums
  leave it open, is then never backed;
* *possible* if a beam came near and the three don't all say the opposite;
* *plain* if all three say the same by a wide margin: then any sound map has it so.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from math import ceil, floor, inf

from bugbot.frames import direction
from mapping.beam import FAR_CM
from mapping.frontiers import State
from mapping.grid import Grid
from mapping.log_odds import KNOWN, L_FREE, L_MAX, L_OCC

__all__ = ["Beam", "Evidence"]

Beam = tuple[float, float, float, float]
"""x, y where it began [cm], its angle [degrees clockwise from up the mat], its reading [cm]."""

_PLAIN = 2.0
"""Log odds this far out, by every rule, are plain: twice what makes a cell known."""

_OPPOSITE = KNOWN
"""Log odds this far on the other side, by every rule, say the opposite."""


class Evidence:
    """What the beams of a run say of the cells of a grid.

    crossed  how many beams went through each cell and on
    ended    how many ended in it

    >>> evidence = Evidence(Grid(50), [(25, 25, 0, 130)])
    >>> evidence.crossed[0], evidence.ended[12], evidence.supports(12, State.OCCUPIED)
    (1, 1, False)
    """

    def __init__(self, grid: Grid, beams: Iterable[Beam], far_cm: float = FAR_CM) -> None:
        size = len(grid.cells)
        self.grid = grid
        self.crossed = [0] * size
        self.ended = [0] * size
        self._sums = ([0.0] * size, [0.0] * size, [0.0] * size)
        for x, y, angle, reading in beams:
            self._follow(x, y, angle, reading, far_cm)

    @cached_property
    def low(self) -> list[float]:
        """The lowest of the three sums of each cell's log odds."""
        return [min(sums) for sums in zip(*self._sums, strict=True)]

    @cached_property
    def high(self) -> list[float]:
        """The highest of the three."""
        return [max(sums) for sums in zip(*self._sums, strict=True)]

    def supports(self, index: int, state: State, known: float = KNOWN) -> bool:
        """Whether one of the rules finds the cell in that state, beyond `known` log odds."""
        if state is State.FREE:
            return self.low[index] < -known
        return state is State.UNKNOWN or self.high[index] > known

    def backs(self, index: int, state: State, known: float = KNOWN) -> bool:
        """Whether it is supported and, if free, found free by all of the rules."""
        if state is State.FREE:
            return self.high[index] < -known
        return self.supports(index, state, known)

    def allows(self, index: int, state: State, reach: int = 1) -> bool:
        """Whether a beam says so within `reach` cells, and all the rules don't say the opposite.

        reach  1 for true poses; one more for each cell that the poses may be off
        """
        if state is State.UNKNOWN:
            return True
        if reach == 1 and self._is_opposite(index, state):
            return False
        counts = self.crossed if state is State.FREE else self.ended
        return any(
            counts[near] and not self._is_opposite(near, state)
            for near in self._within(index, reach)
        )

    def plain(self, index: int) -> State:
        """What the cell must be, as all rules agree by a wide margin; UNKNOWN if they don't."""
        if self.high[index] < -_PLAIN and not self.ended[index]:
            return State.FREE
        return State.OCCUPIED if self.low[index] > _PLAIN else State.UNKNOWN

    # -- inside --------------------------------------------------------------

    def _is_opposite(self, index: int, state: State) -> bool:
        if state is State.FREE:
            return self.low[index] > _OPPOSITE
        return self.high[index] < -_OPPOSITE

    def _within(self, index: int, reach: int) -> list[int]:
        """The cells up to `reach` columns and rows away, the cell itself among them."""
        column, row = self.grid.cell(index)
        last = self.grid.across - 1
        return [
            up * self.grid.across + right
            for up in range(max(0, row - reach), min(last, row + reach) + 1)
            for right in range(max(0, column - reach), min(last, column + reach) + 1)
        ]

    def _follow(self, x: float, y: float, angle: float, reading: float, far_cm: float) -> None:
        """Add one beam, cell by cell."""
        steps, once, to_hit = self._sums
        across, side = self.grid.across, self.grid.cell_cm
        half = side / 2
        found = reading < far_cm
        end = reading if found else far_cm
        clear = reading - side if found else far_cm
        last_step = int(clear / half) if clear > 0 else 0
        dx, dy = direction(angle)
        column, row = floor(x / side), floor(y / side)
        # How far along the beam the next column begins, and the next row.
        next_x = ((column + (dx > 0)) * side - x) / dx if dx else inf
        next_y = ((row + (dy > 0)) * side - y) / dy if dy else inf
        wide, high = (side / abs(dx) if dx else inf), (side / abs(dy) if dy else inf)
        right, up = (1 if dx > 0 else -1), (1 if dy > 0 else -1)
        here, step = 0.0, 0
        while here < end and 0 <= column < across and 0 <= row < across:
            index = row * across + column
            entered = here
            if next_x < next_y:
                here, next_x, column = next_x, next_x + wide, column + right
            else:
                here, next_y, row = next_y, next_y + high, row + up
            steps_here = min(last_step, ceil(here / half))
            if steps_here > step:
                steps[index] = max(-L_MAX, steps[index] + L_FREE * (steps_here - step))
                step = steps_here
            if found and here >= end:
                self.ended[index] += 1
                for sums in self._sums:
                    sums[index] = min(L_MAX, sums[index] + L_OCC)
                return
            self.crossed[index] += 1
            to_hit[index] = max(-L_MAX, to_hit[index] + L_FREE)
            if entered < clear or entered == 0.0:
                once[index] = max(-L_MAX, once[index] + L_FREE)
