"""A map held against the truth: how much is known, and how much of it is wrong.

May import: the standard library, `bugbot.frames`, `mapping.grid`, `mapping.frontiers`.

When is a black cell wrong? "Further than one cell from anything real" can be read
in several ways; this is the one taken here, and why.

* What is real: the obstacles as full rectangles, and the four edges of the mat.
* From where: from the cell's middle, as the cell stands for the middle wherever a map
  is drawn or used.
* How far: straight (Euclidean) distance to the nearest real point, 0 inside an obstacle.
* Wrong if that is more than the side of a cell.

A wall that was hit where it stands passes: the cell holds the wall's face, so its middle is
within half a diagonal, 0.71 of a cell. The cell in front of it may still pass, if its
middle is nearer than one cell: that is the thickness noise alone gives a wall. The
next cell never does. At the mat's edge this means that the outermost row of cells is
right (its middles are half a cell from the edge) and the second is wrong.

Reading it as "no real cell among the eight around it" would be kinder by up to a
cell along the mat's edge: the drifted map of demo 3 would then lose about a quarter of
its wrong walls, though they are as doubled as before.

A map without a single black cell has no wrong walls. So two more figures are counted.

* Wrong floor: free cells whose middle is inside an obstacle. A wall's face may run anywhere
  through its cell, which is the allowance: up to half of such a cell can be floor.
* Walls found: of the cells in which beams have really met a surface, how many have a black cell
  there or beside them. `SEEN_LEAST` beams have to have met it, as one or two hits, spread by
  noise, need not make a cell black. One cell beside is the thickness that noise gives a wall.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import hypot

from bugbot.frames import MAT_CM
from mapping.frontiers import State
from mapping.grid import Grid

__all__ = ["SEEN_LEAST", "Rectangle", "Score", "gap_cm", "score", "surfaces_found"]

SEEN_LEAST = 3
"""A surface that fewer beams have met need not be on a map."""

Rectangle = tuple[float, float, float, float]
"""An obstacle: x and y of its lower left corner, width, height [cm]."""


@dataclass(frozen=True, slots=True)
class Score:
    """A map in numbers.

    cells          how many the grid has
    free           how many the map calls free
    occupied       how many it calls occupied
    wrong_walls    indices of the occupied cells with nothing real near, in order
    wrong_floor    indices of the free cells whose middle is inside an obstacle, in order
    """

    cells: int
    free: int
    occupied: int
    wrong_walls: tuple[int, ...]
    wrong_floor: tuple[int, ...]

    @property
    def known_percent(self) -> float:
        """Share of all cells that are free or occupied, 0 to 100."""
        return 100.0 * (self.free + self.occupied) / self.cells

    @property
    def wrong_walls_percent(self) -> float:
        """Share of the occupied cells that have nothing real near, 0 to 100; 0 if none are."""
        return 100.0 * len(self.wrong_walls) / max(1, self.occupied)

    @property
    def wrong_floor_percent(self) -> float:
        """Share of the free cells that are inside an obstacle, 0 to 100; 0 if none are."""
        return 100.0 * len(self.wrong_floor) / max(1, self.free)


def gap_cm(x: float, y: float, obstacles: Iterable[Rectangle]) -> float:
    """Distance [cm] from a point on the mat to the nearest obstacle or the mat's edge.

    0 inside an obstacle.

    >>> gap_cm(100, 20, []), gap_cm(100, 20, [(103, 24, 10, 10)])
    (20, 5.0)
    """
    gap = min(x, MAT_CM - x, y, MAT_CM - y)
    for left, bottom, width, height in obstacles:
        beside = max(left - x, 0.0, x - (left + width))
        above = max(bottom - y, 0.0, y - (bottom + height))
        gap = min(gap, hypot(beside, above))
    return gap


def score(grid: Grid, states: Sequence[State], obstacles: Iterable[Rectangle]) -> Score:
    """Count a map's cells and hold them against what really stands on the mat."""
    real = list(obstacles)
    free = [index for index, state in enumerate(states) if state is State.FREE]
    occupied = [index for index, state in enumerate(states) if state is State.OCCUPIED]
    return Score(
        cells=len(states),
        free=len(free),
        occupied=len(occupied),
        wrong_walls=tuple(i for i in occupied if gap_cm(*grid.centre(i), real) > grid.cell_cm),
        wrong_floor=tuple(i for i in free if gap_cm(*grid.centre(i), real) == 0.0),
    )


def surfaces_found(
    grid: Grid, states: Sequence[State], met: Mapping[int, int], least: int = SEEN_LEAST
) -> tuple[list[int], list[int]]:
    """The cells with a surface that beams have met: those that the map shows, and the others.

    met    how many beams really met a surface in each cell, by the cell's index
    least  a surface that fewer have met is left out

    >>> surfaces_found(Grid(100), [State.OCCUPIED, *[State.FREE] * 3], {3: 5, 2: 1})
    ([3], [])
    """
    found: list[int] = []
    missed: list[int] = []
    for index, beams in sorted(met.items()):
        if beams >= least:
            near = (index, *grid.around(index))
            shown = any(states[each] is State.OCCUPIED for each in near)
            (found if shown else missed).append(index)
    return found, missed
