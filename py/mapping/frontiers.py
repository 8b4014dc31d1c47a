"""From log odds to decisions: three states, frontiers, regions, and where to go next.

May import: the standard library, `bugbot.frames`, `bugbot.errors`, `mapping.grid`,
`mapping.log_odds`.

Frontier-based exploration is Yamauchi's (1997): the most is to be learned where free floor meets
the unknown, so gather those cells into regions, leave out the small ones, and go to
the nearest that can be reached.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from enum import IntEnum
from math import dist, floor, inf

from bugbot.errors import WrongValueError
from bugbot.frames import MAT_CM
from mapping.grid import Grid, Point
from mapping.log_odds import KNOWN, log_odds

__all__ = [
    "FREE_P",
    "MIN_REGION",
    "OCC_P",
    "SPARE_CM",
    "State",
    "choose_goal",
    "clear_line",
    "frontier_cells",
    "gap_to_walls",
    "known_states",
    "regions",
    "states_by_probability",
    "three_states",
]

OCC_P = 0.65
FREE_P = 0.35
"""The thresholds of demo 4: occupied above OCC_P, free below FREE_P."""

MIN_REGION = 5
"""Frontier regions of fewer cells are not worth a drive: most are noise at a wall."""

SPARE_CM = 6.0
"""How far the robot's middle keeps from walls [cm]: its radius is 5."""


class State(IntEnum):
    """What a map says of a cell, with the values of a ROS occupancy grid."""

    UNKNOWN = -1
    FREE = 0
    OCCUPIED = 100


def three_states(cells: Iterable[float], free_below: float, occupied_above: float) -> list[State]:
    """Each cell's log odds sorted by two thresholds [log odds]; between them is unknown.

    Raises WrongValueError if a cell could be free and occupied at once.
    """
    if not free_below <= occupied_above:
        raise WrongValueError(
            "three_states wants free_below at or under occupied_above; "
            f"it got {free_below!r} and {occupied_above!r}"
        )
    return [_state(each, free_below, occupied_above) for each in cells]


def known_states(cells: Iterable[float], known: float = KNOWN) -> list[State]:
    """Three states as demos 1 to 3 have them: known beyond `known` log odds, either way."""
    return three_states(cells, -known, known)


def states_by_probability(
    cells: Iterable[float], free_p: float = FREE_P, occ_p: float = OCC_P
) -> list[State]:
    """Three states as map files have them: thresholds as probabilities, 0 and 1 excluded."""
    return three_states(cells, log_odds(free_p), log_odds(occ_p))


def frontier_cells(grid: Grid, states: Sequence[State]) -> set[int]:
    """The free cells with an unknown cell at one of their sides."""
    return {
        free
        for unknown, state in enumerate(states)
        if state is State.UNKNOWN
        for free in grid.beside(unknown)
        if states[free] is State.FREE
    }


def regions(grid: Grid, cells: Iterable[int], *, corners: bool = False) -> list[list[int]]:
    """Cells in groups that hang together by their sides, by flood fill; largest first.

    With `corners` cells that touch at a corner hang together too, as in explore_lite: a
    frontier that runs slantwise is then one region and not a flight of single steps. Groups of
    one size come in the order of their lowest cell, and so do the cells of a
    group, so that the answer is the same on every machine.
    """
    neighbours = grid.around if corners else grid.beside
    left = set(cells)
    groups = []
    while left:
        group = [left.pop()]
        for cell in group:  # the list grows while it is walked along
            new = left.intersection(neighbours(cell))
            group.extend(new)
            left -= new
        groups.append(sorted(group))
    return sorted(groups, key=lambda group: (-len(group), group[0]))


def clear_line(
    grid: Grid, states: Sequence[State], here: Point, goal: Point, spare_cm: float = SPARE_CM
) -> bool:
    """Whether a robot can go straight from here to the goal, as far as the map knows.

    Every half-cell step of the line must be on a free cell, no occupied cell may be
    within `spare_cm` of it (a cell counts as the disc that just fits into it), and the
    goal must be `spare_cm` from the mat's edge.
    """
    if not all(spare_cm <= side <= MAT_CM - spare_cm for side in goal):
        return False
    length = dist(here, goal)
    steps = floor(length / (grid.cell_cm / 2)) + 1
    for i in range(steps + 1):
        index = grid.index_at(*_between(here, goal, i / steps))
        if index is None or states[index] is not State.FREE:
            return False
    walls = (grid.centre(index) for index, state in enumerate(states) if state is State.OCCUPIED)
    return gap_to_walls(walls, grid.cell_cm, here, goal) >= spare_cm


def gap_to_walls(walls: Iterable[Point], cell_cm: float, here: Point, goal: Point) -> float:
    """The smallest gap [cm] between a straight line and wall cells, given by their middles.

    Each counts as the disc that just fits into it; infinity without any.

    >>> gap_to_walls([(50, 50)], 5, (0, 60), (100, 60))
    7.5
    """
    gaps = (_gap_to_line(middle, here, goal) for middle in walls)
    return min(gaps, default=inf) - cell_cm / 2


def choose_goal(
    grid: Grid,
    states: Sequence[State],
    here: Point,
    *,
    min_region: int = MIN_REGION,
    spare_cm: float = SPARE_CM,
) -> Point | None:
    """Middle of the nearest frontier cell worth driving to [cm]; None if there is none.

    Worth it is a cell of a region of at least `min_region` cells that `clear_line` can
    reach from `here`. Of two equally near cells the lower index wins.
    """
    worth = [
        cell
        for region in regions(grid, frontier_cells(grid, states))
        if len(region) >= min_region
        for cell in region
    ]
    for cell in sorted(worth, key=lambda cell: (dist(here, grid.centre(cell)), cell)):
        if clear_line(grid, states, here, grid.centre(cell), spare_cm):
            return grid.centre(cell)
    return None


def _state(cell: float, free_below: float, occupied_above: float) -> State:
    if cell > occupied_above:
        return State.OCCUPIED
    return State.FREE if cell < free_below else State.UNKNOWN


def _between(here: Point, goal: Point, share: float) -> Point:
    return here[0] + share * (goal[0] - here[0]), here[1] + share * (goal[1] - here[1])


def _gap_to_line(point: Point, here: Point, goal: Point) -> float:
    """Distance [cm] from a point to the nearest point between here and goal."""
    dx, dy = goal[0] - here[0], goal[1] - here[1]
    squared = dx * dx + dy * dy
    if squared == 0.0:
        return dist(point, here)
    share = ((point[0] - here[0]) * dx + (point[1] - here[1]) * dy) / squared
    return dist(point, _between(here, goal, max(0.0, min(1.0, share))))
