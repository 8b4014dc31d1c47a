"""Mats that nobody has drawn: the world of a number, always the same for the same number.

May import: the standard library, `bugbot`.

Six characters take turns. On each mat the robot starts at (100, 25), as on the mats of U8.7, and
all floor can be seen from where the robot can be, but for the inside of a closet with a slit.
`mat` draws until that holds, with room to spare for a map that is a cell too thick.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import hypot
from random import Random

from bugbot.frames import MAT_CM
from bugbot.worlds import World

__all__ = ["KINDS", "START", "floor_cells", "mat"]

START = (100.0, 25.0)

_STEP_CM = 2.5
_ACROSS = int(MAT_CM / _STEP_CM)
"""Floor is looked at on a lattice this fine."""

_ROOM_CM = 10.0
"""So far from the robot's middle to anything solid (its radius is 5): gaps of 20 cm are ways."""

_NEAR_STEPS = 9
"""Floor up to so many steps from a way is within its sight: a corner is eight steps off."""

Rectangle = tuple[float, float, float, float, str]
"""x, y of the lower left corner, width, height [cm], and the word for it."""


def mat(number: int) -> World:
    """The world of a number, 0 or more; its kind is `KINDS[number % len(KINDS)]`."""
    name = list(KINDS)[number % len(KINDS)]
    chance = Random(number)
    while True:
        rectangles = [_on_the_mat(each) for each in KINDS[name](chance)]
        if _is_sensible(rectangles, closet=name == "closet"):
            break
    turns = chance.randrange(8)
    return World.from_dict(
        {
            "name": f"mat-{number}",
            "title": f"Mat {number}: {name}",
            "description": f"Made from the number {number}.",
            "obstacles": [
                {"x": x, "y": y, "width": wide, "height": high, "name": word}
                for x, y, wide, high, word in rectangles
            ],
            "start": {"x": START[0], "y": START[1], "heading": 45 * turns},
        },
        f"mat {number}",
    )


def _on_the_mat(rectangle: Rectangle) -> Rectangle:
    """What of a rectangle is on the mat: a wall that joins the edge may have been drawn over it."""
    x, y, wide, high, word = rectangle
    left, bottom = max(0.0, x), max(0.0, y)
    return left, bottom, min(MAT_CM, x + wide) - left, min(MAT_CM, y + high) - bottom, word


# -- the characters ----------------------------------------------------------------


def _rooms(chance: Random) -> Iterator[Rectangle]:
    """Two walls that cross, a doorway in three or four of their arms, and some furniture."""
    x, y = chance.randrange(70, 131), chance.randrange(80, 131)
    thick = chance.randrange(5, 9)
    arms = [(0, x, True), (x + thick, 200, True), (0, y, False), (y + thick, 200, False)]
    closed = chance.randrange(5)  # one of the arms, or none
    walls: list[Rectangle] = []
    for number, (low, high, level) in enumerate(arms):
        door = chance.randrange(26, 37)
        at = chance.randrange(low + 8, high - 8 - door)
        parts = [(low, high)] if number == closed else [(low, at), (at + door, high)]
        for a, b in parts:
            walls.append((a, y, b - a, thick, "wall") if level else (x, a, thick, b - a, "wall"))
    walls.append((x, y, thick, thick, "wall"))
    yield from walls
    yield from _boxes(chance, chance.randrange(2, 5), 10, 25, walls)


def _clutter(chance: Random) -> Iterator[Rectangle]:
    """Furniture of many sizes."""
    yield from _boxes(chance, chance.randrange(6, 11), 8, 45, [])


def _maze(chance: Random) -> Iterator[Rectangle]:
    """Corridors with dead ends: five by five places, joined as a tree, and a side or two more."""
    thick, side = 6, MAT_CM / 5
    joined = {(2, 0)}
    open_sides = set()
    places = [(c, r) for r in range(5) for c in range(5)]
    sides = [(a, b) for a in places for b in ((a[0] + 1, a[1]), (a[0], a[1] + 1)) if b in places]
    while len(joined) < len(places):
        a, b = chance.choice([each for each in sides if (each[0] in joined) != (each[1] in joined)])
        open_sides.add((a, b))
        joined |= {a, b}
    for _ in range(chance.randrange(1, 3)):
        open_sides.add(chance.choice(sides))
    for a, b in sides:
        if (a, b) not in open_sides:
            x, y = b[0] * side, b[1] * side
            if a[1] == b[1]:
                yield x - thick / 2, y - thick / 2, thick, side + thick, "wall"
            else:
                yield x - thick / 2, y - thick / 2, side + thick, thick, "wall"


def _screens(chance: Random) -> Iterator[Rectangle]:
    """Walls across the mat, each with one way round at an end."""
    count = chance.randrange(2, 5)
    for number in range(count):
        y = 200 * (number + 1) / (count + 1) + chance.randrange(-4, 5)
        gap = chance.randrange(28, 50)
        left = chance.random() < 0.5
        yield (gap if left else 0), y, 200 - gap, chance.randrange(4, 9), "screen"


def _pillars(chance: Random) -> Iterator[Rectangle]:
    """Posts in rows that are not quite straight."""
    across = chance.randrange(3, 5)
    for row in range(across):
        for column in range(across):
            x = 200 * (column + 0.7) / (across + 0.4) + chance.randrange(-6, 7)
            y = 200 * (row + 0.7) / (across + 0.4) + chance.randrange(-6, 7)
            yield x, y, chance.randrange(6, 15), chance.randrange(6, 15), "post"


def _closet(chance: Random) -> Iterator[Rectangle]:
    """A closet that can be looked into through a slit and not entered, and furniture round it."""
    x, y = chance.randrange(30, 111), chance.randrange(80, 121)
    wide, high, slit = chance.randrange(40, 61), chance.randrange(35, 56), 6
    at = chance.randrange(8, high - 8 - slit)
    closet: list[Rectangle] = [
        (x, y, wide, 4, "closet"),
        (x, y + high - 4, wide, 4, "closet"),
        (x, y + 4, 4, high - 8, "closet"),
        (x + wide - 4, y + 4, 4, at - 4, "closet"),
        (x + wide - 4, y + at + slit, 4, high - 4 - at - slit, "closet"),
    ]
    yield from closet
    yield from _boxes(chance, chance.randrange(2, 5), 10, 30, closet)


def _boxes(
    chance: Random, count: int, least: int, most: int, others: list[Rectangle]
) -> Iterator[Rectangle]:
    """Boxes that leave ways as wide as `_ROOM_CM` asks for; some stand against the mat's edge."""
    standing = list(others)
    for _ in range(count):
        for _ in range(40):  # tries: on a full mat there may be no place left
            wide, high = chance.randrange(least, most + 1), chance.randrange(least, most + 1)
            x, y = chance.randrange(0, 201 - wide), chance.randrange(0, 201 - high)
            x, y = chance.choice([(x, y), (x, y), (0, y), (200 - wide, y), (x, 200 - high)])
            box = (x, y, wide, high, "box")
            if _has_ways_round(box, standing):
                standing.append(box)
                yield box
                break


def _has_ways_round(box: Rectangle, others: list[Rectangle]) -> bool:
    x, y, wide, high, _ = box
    way = 2 * _ROOM_CM + 2
    sides = (x, MAT_CM - x - wide, y, MAT_CM - y - high)
    start = (START[0] - 1, START[1] - 1, 2, 2, "start")
    return all(side == 0 or side >= way for side in sides) and all(
        max(left - x - wide, x - left - width, bottom - y - high, y - bottom - height) >= way
        for left, bottom, width, height, _ in [*others, start]
    )


KINDS: dict[str, Callable[[Random], Iterator[Rectangle]]] = {
    "rooms": _rooms,
    "clutter": _clutter,
    "maze": _maze,
    "screens": _screens,
    "pillars": _pillars,
    "closet": _closet,
}


# -- whether a robot can map it ----------------------------------------------------

_WIDE = _ACROSS + 2
"""A row of the lattice, with a point beyond the mat at each end: so nothing need ask for edges."""


def floor_cells(world: World, cell_cm: float = 5.0) -> set[tuple[int, int]]:
    """The cells with floor that hangs together with the start's: all that a map could know."""
    solids = [(each.x, each.y, each.width, each.height, "") for each in world.obstacles]
    seen = _spread([_at(*START)], _points(solids, 0.0))
    points = (divmod(index, _WIDE) for index, is_floor in enumerate(seen) if is_floor)
    per_cell = cell_cm / _STEP_CM
    return {(int((column - 1) // per_cell), int((row - 1) // per_cell)) for row, column in points}


def _is_sensible(rectangles: list[Rectangle], *, closet: bool) -> bool:
    """Whether the start is clear, and floor is within sight of the ways a robot can go."""
    ways = _points(rectangles, _ROOM_CM)
    if not ways[_at(*START)]:
        return False
    floor = _points(rectangles, 0.0)
    gone = _spread([_at(*START)], ways)
    near = _spread([index for index, is_way in enumerate(gone) if is_way], floor, _NEAR_STEPS)
    hidden = sum(floor) - sum(near)
    return hidden == 0 or (closet and hidden < sum(floor) / 10)


def _at(x: float, y: float) -> int:
    return (int(y / _STEP_CM) + 1) * _WIDE + int(x / _STEP_CM) + 1


def _points(rectangles: list[Rectangle], room_cm: float) -> bytearray:
    """1 for each point of the lattice with so much room to everything solid and the mat's edge."""
    points = bytearray(_WIDE * _WIDE)
    middles = [(number, (number - 0.5) * _STEP_CM) for number in range(1, _ACROSS + 1)]
    inside = [each for each in middles if room_cm <= each[1] <= MAT_CM - room_cm]
    for row, _ in inside:
        for column, _ in inside:
            points[row * _WIDE + column] = 1
    for left, bottom, wide, high, _ in rectangles:
        columns = [(n, _gap(x, left, left + wide)) for n, x in middles]
        rows = [(n, _gap(y, bottom, bottom + high)) for n, y in middles]
        for row, above in [each for each in rows if each[1] <= room_cm]:
            for column, aside in [each for each in columns if each[1] <= room_cm]:
                if hypot(aside, above) <= room_cm:
                    points[row * _WIDE + column] = 0
    return points


def _gap(value: float, low: float, high: float) -> float:
    return max(low - value, 0.0, value - high)


def _spread(start: list[int], ways: bytearray, steps: int = _WIDE * _WIDE) -> bytearray:
    """1 for each point that is at most so many steps over points of `ways` from the start."""
    reached = bytearray(len(ways))
    for index in start:
        reached[index] = 1
    edge = start
    while edge and steps:
        new = []
        for index in edge:
            for beside in (index - 1, index + 1, index - _WIDE, index + _WIDE):
                if ways[beside] and not reached[beside]:
                    reached[beside] = 1
                    new.append(beside)
        edge, steps = new, steps - 1
    return reached
