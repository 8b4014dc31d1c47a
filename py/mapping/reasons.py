"""Why an explorer stops: which reason its words give, and whether the run bears it out.

May import: the standard library, `mapping.frontiers`, `mapping.grid`.

The reasons are those of lesson U8.7. A program says one in words of its own; a few words tell
which is meant. What the words claim is then held against the map that the program has drawn last,
its path and its time. A claim is only called untrue where no sensible program could make it:

* "none": there is no frontier cell, as U8.6 defines them, on the map.
* "small": no region of `LARGE` cells is left that the robot has not been near to.
* "shut": there is a frontier, and no such region that could be reached with a lot of room.
* "far": `far_cm` are driven, or would be before the nearest frontier is reached.
* "time": `time_s` have passed.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from math import dist, hypot

from mapping.frontiers import State, frontier_cells, regions
from mapping.grid import Grid, Point

__all__ = ["LARGE", "Stop", "Untrue", "reason_in", "untrue"]

LARGE = 20
"""A region of so many cells is not small, however a program sets its limit (1 to 20 in U8.7)."""

_LOOKED_AT_CM = 30.0
"""A frontier that the robot has come so near to may have been looked at in vain."""

_ROOM_CM = 14.0
"""With so much free floor round its middle, any program's robot (radius 5) can go there."""

_BESIDE_CM = 15.0
"""So near to a frontier the robot has reached it."""

_WINDING = 2.0
"""A way may be so many times as long as the straight line."""

_WORDS = (
    ("time", r"\btime\b|\bclock\b|\bseconds\b|\btimeout\b"),
    ("shut", r"\breach|\bget to\b|\bno way\b|\bno path\b|\bblocked\b|\bshut\b|\binaccessible\b"),
    ("far", r"\bfar\b|\bdistance\b|\bdriven\b|\bmetres?\b|\bmeters?\b"),
    ("small", r"\bsmall|\btiny\b|\btoo few\b"),
    (
        "none",
        r"\b(no|none|nothing|not a)\b.*\b(frontiers?|left|unknown|more|explore)\b"
        r"|\b(complete|completed|finished|all|everything|done|explored)\b",
    ),
)


@dataclass(frozen=True, slots=True)
class Stop:
    """The end of a run.

    states   the map that the program has drawn last, cell by cell
    path     places it has been at, the last one at its end [cm]
    driven   the length of its path [cm]
    seconds  the time it took [s]
    """

    grid: Grid
    states: Sequence[State]
    path: Sequence[Point]
    driven: float
    seconds: float


@dataclass(frozen=True, slots=True)
class Untrue:
    """What would make a reason true, what is so instead, and the cells that show it."""

    wanted: str
    found: str
    cells: tuple[int, ...] = ()


def reason_in(words: str) -> str | None:
    """The reason that some words give: none, small, shut, far or time; None if they give none.

    >>> reason_in("no frontier can be reached"), reason_in("lunch")
    ('shut', None)
    """
    for reason, pattern in _WORDS:
        if re.search(pattern, words.lower()):
            return reason
    return None


def untrue(reason: str, stop: Stop, *, far_cm: float, time_s: float) -> Untrue | None:
    """Why a reason can't be true of a run; None if it can.

    far_cm  so far a robot must have driven to have driven far enough [cm]
    time_s  so long it must have taken for the time to be up [s]
    """
    frontier = frontier_cells(stop.grid, stop.states)
    if reason == "time":
        if stop.seconds >= time_s:
            return None
        return Untrue(f"time is up from {time_s:g} s on", f"it stopped after {stop.seconds:.1f} s")
    if reason == "far":
        return _not_far(stop, frontier, far_cm)
    if reason == "none":
        if not frontier:
            return None
        one = len(frontier) == 1
        there = "there is 1 frontier cell" if one else f"there are {len(frontier)} frontier cells"
        return Untrue("no frontier cell on its last map", there, _sorted(frontier))
    large = _large(stop, frontier)
    if reason == "small":
        if not large:
            return None
        return Untrue(
            f"no frontier of {LARGE} cells or more on its last map that it has not been near to",
            f"there is one of {len(large[0])} cells",
            tuple(large[0]),
        )
    if not frontier:
        return Untrue("a frontier on its last map that can't be reached", "no frontier is left")
    open_ones = [each for each in large if _can_be_reached(stop, each)]
    if not open_ones:
        return None
    return Untrue(
        "no large frontier on its last map with a wide way to it",
        f"there is a way to one of {len(open_ones[0])} cells",
        tuple(open_ones[0]),
    )


def _sorted(cells: set[int]) -> tuple[int, ...]:
    return tuple(sorted(cells))


def _not_far(stop: Stop, frontier: set[int], far_cm: float) -> Untrue | None:
    ways = (dist(stop.path[-1], stop.grid.centre(cell)) for cell in frontier)
    way = _WINDING * min(ways, default=0.0)
    if stop.driven + way >= far_cm:
        return None
    return Untrue(
        f"it has driven far enough from {far_cm:g} cm on, the way to the next frontier included",
        f"it drove {stop.driven:.0f} cm",
    )


def _large(stop: Stop, frontier: set[int]) -> list[list[int]]:
    """The regions of frontier cells that the robot has not been near to, the large ones."""
    places = {(round(x, -1), round(y, -1)) for x, y in stop.path}
    fresh = [
        cell
        for cell in frontier
        if all(dist(stop.grid.centre(cell), place) > _LOOKED_AT_CM for place in places)
    ]
    return [each for each in regions(stop.grid, fresh, corners=True) if len(each) >= LARGE]


def _can_be_reached(stop: Stop, region: Sequence[int]) -> bool:
    """Whether a robot with a lot of room round it could come beside a region."""
    grid, states = stop.grid, stop.states
    here = stop.path[-1]
    roomy = _roomy(grid, states)
    reached = _flood(grid, roomy | _free_near(grid, states, here), grid.index_at(*here))
    there = [grid.centre(each) for each in region]
    return any(
        each in roomy and any(dist(grid.centre(each), cell) <= _BESIDE_CM for cell in there)
        for each in reached
    )


def _roomy(grid: Grid, states: Sequence[State]) -> set[int]:
    """The free cells with nothing but free floor within `_ROOM_CM` of their middle, on the mat."""
    reach = int(_ROOM_CM / grid.cell_cm)
    steps = [
        (right, up)
        for right in range(-reach, reach + 1)
        for up in range(-reach, reach + 1)
        if hypot(right, up) * grid.cell_cm <= _ROOM_CM
    ]
    found = set()
    for index, state in enumerate(states):
        if state is not State.FREE:
            continue
        column, row = grid.cell(index)
        around = [(column + right, row + up) for right, up in steps]
        if all(grid.holds(c) and states[grid.index(c)] is not State.OCCUPIED for c in around):
            found.add(index)
    return found


def _free_near(grid: Grid, states: Sequence[State], here: Point) -> set[int]:
    """The free cells round the robot: where it stands it fits, however narrow it is."""
    return {
        index
        for index, state in enumerate(states)
        if state is State.FREE and dist(grid.centre(index), here) <= _ROOM_CM
    }


def _flood(grid: Grid, cells: set[int], start: int | None) -> list[int]:
    if start is None:
        return []
    reached, left = [start], cells - {start}
    for each in reached:  # the list grows while it is walked along
        new = left.intersection(grid.beside(each))
        reached.extend(new)
        left -= new
    return reached
