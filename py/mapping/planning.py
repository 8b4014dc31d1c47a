"""Ways for a robot that has a size: where it has room, A*, and which frontier first.

May import: the standard library, `bugbot.errors`, `mapping.grid`, `mapping.frontiers`.

A disc among walls is hard to plan for, a point among thicker walls is easy. So take away
from the free floor all that is nearer to anything solid than the robot may come; what is left is
its *room*, and there it may be planned for as a point. (In Nav2 the same is the inflation
layer of a costmap.) Unknown counts as solid: what nobody has seen may be a wall.

Cells are places in the flat list of a `Grid`; `room` is a set of them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence, Set
from heapq import heappop, heappush
from itertools import pairwise
from math import dist, hypot, inf

from bugbot.errors import WrongValueError, got
from mapping.frontiers import SPARE_CM, State
from mapping.grid import Grid, Point

__all__ = [
    "choose_region",
    "look_out",
    "reachable",
    "room_cells",
    "shortest_way",
    "way_cm",
]


def room_cells(grid: Grid, states: Sequence[State], spare_cm: float = SPARE_CM) -> set[int]:
    """The free cells on whose middle a robot keeps `spare_cm` from all that is not free.

    A cell that is not free counts as the disc that just fits into it, and so do the cells
    that would follow beyond the mat's edge.

    >>> grid = Grid(20)
    >>> len(room_cells(grid, [State.FREE] * 100, spare_cm=10.5))
    64
    """
    if not spare_cm >= 0:  # True for NaN too
        raise WrongValueError(
            f"room_cells(grid, states, spare_cm) wants 0 or more (cm); it got {got(spare_cm)}"
        )
    far = spare_cm + grid.cell_cm / 2
    reach = range(-int(far / grid.cell_cm), int(far / grid.cell_cm) + 1)
    near = [(c, r) for c in reach for r in reach if hypot(c, r) * grid.cell_cm < far]
    free = {grid.cell(index) for index, state in enumerate(states) if state is State.FREE}
    return {
        grid.index((column, row))
        for column, row in free
        if all((column + c, row + r) in free for c, r in near)
    }


def reachable(grid: Grid, start: int, room: Set[int]) -> set[int]:
    """All cells of `room` that hang together with `start` by their sides, and `start` itself."""
    found = [start]
    left = set(room) - {start}
    for cell in found:  # the list grows while it is walked along
        new = left.intersection(grid.beside(cell))
        found.extend(new)
        left -= new
    return set(found)


def shortest_way(grid: Grid, start: int, goal: int, room: Set[int]) -> list[int]:
    """A*: the shortest way from cell to cell through `room`, both ends included; [] if none.

    A step goes to one of the eight cells around; to a corner only if the two cells beside that
    step have room too, so that no way cuts a corner. What is still to go is
    estimated by the straight distance, which is never too long: so the first way found is a
    shortest one. The same way on every machine.
    """
    if start not in room or goal not in room:
        return []
    length, before = {start: 0.0}, {start: start}
    waiting = [(_apart(grid, start, goal), start)]
    while waiting:
        cell = heappop(waiting)[1]
        if cell == goal:
            way = [cell]
            while way[-1] != start:
                way.append(before[way[-1]])
            return way[::-1]
        for new in _steps(grid, cell, room):
            so_far = length[cell] + _apart(grid, cell, new)
            if so_far < length.get(new, inf):
                length[new], before[new] = so_far, cell
                heappush(waiting, (so_far + _apart(grid, new, goal), new))
    return []


def way_cm(grid: Grid, way: Sequence[int]) -> float:
    """How long a way of cells is, from middle to middle [cm]."""
    return sum(_apart(grid, a, b) for a, b in pairwise(way))


def look_out(
    grid: Grid, region: Collection[int], cells: Iterable[int], near_cm: float
) -> int | None:
    """The cell, of `cells`, to look at a frontier region from; None if all are too far off.

    It must be within `near_cm` of a cell of the region; of those, the one nearest to the
    region's middle, and of two as near the lower index.
    """
    points = [grid.centre(each) for each in region]
    spots = [
        cell for cell in cells if any(dist(grid.centre(cell), point) <= near_cm for point in points)
    ]
    if not spots:
        return None
    middle: Point = (
        sum(x for x, _ in points) / len(points),
        sum(y for _, y in points) / len(points),
    )
    return min(spots, key=lambda cell: (dist(grid.centre(cell), middle), cell))


def choose_region(
    sizes: Sequence[int], ways_cm: Sequence[float], cell_cm: float, gain: float
) -> int | None:
    """Which region to go to, by gain against distance: its place in the lists, None of none.

    Each region is worth `gain` for each of its cells, less its way counted in cells.
    A gain of 0 chooses the nearest. Of two worth the same the first is chosen.

    >>> choose_region([5, 30], [20, 60], 5, gain=0), choose_region([5, 30], [20, 60], 5, gain=1)
    (0, 1)
    """
    worth = [gain * size - way / cell_cm for size, way in zip(sizes, ways_cm, strict=True)]
    return max(range(len(worth)), key=worth.__getitem__, default=None)


def _apart(grid: Grid, a: int, b: int) -> float:
    return dist(grid.centre(a), grid.centre(b))


def _steps(grid: Grid, cell: int, room: Set[int]) -> list[int]:
    """The cells that one step leads to."""
    column, row = grid.cell(cell)
    found = []
    for new in grid.around(cell):
        new_column, new_row = grid.cell(new)
        if {new, grid.index((new_column, row)), grid.index((column, new_row))} <= room:
            found.append(new)
    return found
