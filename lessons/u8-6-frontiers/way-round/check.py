"""find_way(start, goal, room): a shortest route; any that is as short is right."""

from heapq import heappop, heappush
from itertools import chain, pairwise
from math import dist, hypot

from grader import calls, check, exactly, function, in_words, lacks, mistake, number, operator
from mapping.grid import Grid
from mapping.planning import shortest_way

MAT = Grid(10)
SIDES = [(-1, 0), (1, 0), (0, -1), (0, 1)]
CORNERS = [(-1, -1), (1, -1), (-1, 1), (1, 1)]
CELLS = {MAT.cell(index) for index in range(len(MAT.cells))}

# From S to G a search that is nearly right takes a longer route. Small rooms tell it of the fewest
# steps, of an estimate that is too long, and of a length that is never improved.
SMALL_ROOMS = """
##...G. ..##.S. .....## ...G... #.#.... .......
#...... ....... ......S .###... .#..... .#.#...
....... #..##.. ...#... ..##... ....#.. .......
.#..... .#..... ..#..#. ..##... .S##.#. #.....S
.#.#... ##..... G...#.. .##.##. .#.#... ...#...
....#.. G...... ....... ....... .#..#.G .G.....
..#S..# ....... ..#.... .#S.... ....... ..#....
"""
# Larger ones tell it of an estimate a little too long, the last of one that is 1.05 times as long,
# and of a stop when the goal is first seen.
LARGER_ROOMS = """
##......#. ..#....... ..G#.#.... ..#G#..... ..........
.##.S...## ..#..#.... .......... ........#. ........#.
.#........ ....###.S. ....##.#.# .......... #.#.#...#.
#......... #......... ......#... ..#....... .....#.#..
.....#.... .#........ .#.....#.. .......#.. .#..#.....
..#.....#. .....#...# #.....#... .......#.# .........#
##......#. .....#..#. ..#....##. #.......S. #....##.S.
.#....##.. #.#....... ..#.....#S ...#..#... G.......#.
........G. ...#.#.#.. .......... ..#....... ..#.......
.#...#.... ..G.....## ...#...... .##.#..... ..#......#
"""
# 10 steps to corners and 2 to sides, or 3 and 12: shorter only if a step to a corner counts 1.5.
TWO_ROUTES = """
####.....####
###...#...###
##...###...##
#...#####...#
...#######...
S.#########.G
...#########.
#...########.
##...........
"""


def reference(start, goal, room):
    way = shortest_way(MAT, MAT.index(start), MAT.index(goal), set(map(MAT.index, room)))
    return [MAT.cell(index) for index in way]


def long(way):
    return sum(dist(a, b) for a, b in pairwise(way))


def is_step(a, b):
    return 0 < dist(a, b) < 1.5


def are_cells(got):
    return isinstance(got, list | tuple) and all(
        isinstance(each, list | tuple) and len(each) == 2 and all(type(n) is int for n in each)
        for each in got
    )


def length(expected, got):
    """How long a list is as a route between the same two cells; None if it is none."""
    if not are_cells(got):
        return None
    if not expected or not got:
        return None if expected or got else 0
    ends = tuple(got[0]) == expected[0] and tuple(got[-1]) == expected[-1]
    return long(got) if ends and all(is_step(*step) for step in pairwise(got)) else None


def as_short(expected, got):
    """Whether it is a route from start to goal, step by step, and no longer."""
    if isinstance(expected, dict):
        return as_mistaken(expected, got)
    if not isinstance(expected, list):
        return exactly(expected, got)  # no list of cells: a mistake's answer
    found = length(expected, got)
    return found is not None and abs(found - long(expected)) < 1e-6


def in_lengths(expected, got):
    """What is told: lengths, ends and steps, not the cells of the one route that is known here."""
    if not expected or not got or not are_cells(got):
        return None
    got = [tuple(cell) for cell in got]
    if (got[0], got[-1]) != (expected[0], expected[-1]):
        return (
            f"a list that begins with {expected[0]} and ends with {expected[-1]}",
            f"one that begins with {got[0]} and ends with {got[-1]}",
        )
    for a, b in pairwise(got):
        if not is_step(a, b):
            return "steps to one of the eight cells around", f"a step from {a} to {b}"
    shorter = long(got) < long(expected)
    return (
        f"a route {long(expected):.2f} long",
        f"one {long(got):.2f} long{', with a step that is not allowed' if shorter else ''}",
    )


def through(room):
    """The same question, asked of each step too: each must be allowed in this room."""

    def not_allowed(got):
        for a, b in pairwise(got):
            if not {tuple(b), (b[0], a[1]), (a[0], b[1])} <= room:
                return a, b
        return None

    def compare(expected, got):
        return as_short(expected, got) and not (expected and not_allowed(got))

    def apart(expected, got):
        if not as_short(expected, got):
            return in_lengths(expected, got)
        a, b = map(tuple, not_allowed(got))
        return "a route of steps that are allowed", f"a step from {a} to {b}"

    return function(
        "find_way(start, goal, room)", reference, compare=in_words(compare, apart), cell_cm=10
    )


def as_mistaken(slip, got):
    """Whether it is what a mistake answers, by a property where routes may differ."""
    if "steps" in slip:
        return isinstance(got, list | tuple) and len(got) == slip["steps"]
    if "longer than" in slip:
        found = length(slip["longer than"], got)
        return found is not None and found > long(slip["longer than"]) - 1e-6
    if not isinstance(got, list | tuple) or not slip["route"]:
        return got == []
    mended = [*slip["missing first"], *got, *slip["missing last"]]
    return as_short(slip["route"], mended[::-1] if slip["turned round"] else mended)


def but_for(first=False, last=False, turned=False):
    """What a mistake answers in the list of a route, whichever of the shortest it is."""
    return lambda start, goal, room: {
        "route": reference(start, goal, room),
        "missing first": [start] if first else [],
        "missing last": [goal] if last else [],
        "turned round": turned,
    }


def search(cost=dist, steps=SIDES + CORNERS, asks=all, ahead=lambda c, r: 0, once=False):
    """A mistake in it.

    cost   of a step
    asks   whether a step is allowed, told whether the two cells beside it have room
    ahead  the estimate, of the columns and rows to the goal
    once   the first length that is found for a cell is kept
    """

    def find(start, goal, room):
        lengths, before, waiting = {start: 0}, {start: None}, [(0, start)]
        while waiting:
            cell = heappop(waiting)[1]
            if cell == goal:
                way = []
                while cell:
                    way.append(cell)
                    cell = before[cell]
                return way[::-1]
            for c, r in steps:
                new = cell[0] + c, cell[1] + r
                beside = [(new[0], cell[1]) in room, (cell[0], new[1]) in room]
                so_far = lengths[cell] + cost(cell, new)
                better = new not in lengths if once else so_far < lengths.get(new, 1e9)
                if new in room and asks(beside) and better:
                    lengths[new], before[new] = so_far, cell
                    estimate = ahead(abs(new[0] - goal[0]), abs(new[1] - goal[1]))
                    heappush(waiting, (so_far + estimate, new))
        return []

    return find


EMPTY = (
    "the list has to be empty if the search never came to the goal: check for that before you "
    "walk back from it"
)
CUTS = "it cuts corners: "
find_way = function(
    "find_way(start, goal, room)",
    reference,
    compare=in_words(as_short, in_lengths),
    cell_cm=10,
    leaves=True,
    mistakes=[
        (
            f"{CUTS}a step to a corner needs room on both cells beside it",
            search(asks=lambda beside: True),
            2,
        ),
        *[
            (f"{CUTS}both cells beside a step to a corner need room, not one", search(asks=asks), 2)
            for asks in (any, lambda beside: beside[0], lambda beside: beside[1])
        ],
        (
            "only steps to the sides were taken: a step to a corner is shorter than two of them",
            search(steps=SIDES),
            2,
        ),
        (
            "these are the fewest steps, not the shortest route: a step to a corner is sqrt(2) "
            "long, a step to a side 1",
            lambda *asked: {"steps": len(search(cost=lambda a, b: 1)(*asked))},
            1,
        ),
        mistake(
            "columns and rows were added up for the estimate, which makes it too long: "
            "dist(new, goal) never is",
            search(ahead=lambda c, r: c + r),
            0,
            where=calls("abs"),
        ),
        mistake(
            "each cell keeps the first length found for it: a shorter one that is found later "
            "has to replace it",
            search(ahead=hypot, once=True),
            1,
            where=lacks(operator("<", ">", ">=")),
        ),
        (
            "it goes through cells without room: a step leads to a cell of room",
            lambda start, goal, room: search()(start, goal, CELLS),
            2,
        ),
        (
            "the list begins at the goal: walking back from the goal gives it the wrong way round",
            but_for(turned=True),
            0,
        ),
        ("the start is missing: the list begins with it", but_for(first=True), 0),
        ("the goal is missing: the list ends with it", but_for(last=True), 0),
        (
            "start and goal are all there is: the cells between them belong to the list too",
            lambda start, goal, room: [start, goal],
            0,
        ),
        (EMPTY, lambda start, goal, room: reference(start, goal, room) or [goal], 0),
        (EMPTY, lambda start, goal, room: reference(start, goal, room) or {}[goal], 0),
        mistake(
            "a step to a corner counts 1.5, and that is too much: it is sqrt(2) long",
            search(cost=lambda a, b: 1.5 if dist(a, b) > 1 else 1),
            1,
            where=number(1.5),
        ),
        (
            "there is a shorter route. Perhaps the estimate is too long or became part of a "
            "length, or it is not the smallest sum that is taken first",
            lambda *asked: {"longer than": reference(*asked)},
            0,
        ),
        (
            "that is how long the route is: the cells are wanted",
            lambda *asked: long(reference(*asked)) if reference(*asked) else [],
            0,
        ),
    ],
)


def some_room(task, walls):
    room = set(CELLS)
    for _ in range(walls):
        column, row = task.random.randrange(20), task.random.randrange(20)
        size = task.random.randrange(3, 9)
        room -= {(column + i, row) if walls % 2 else (column, row + i) for i in range(size)}
        column, row = task.random.randrange(20), task.random.randrange(20)
        room -= {(column, row + i) for i in range(size)}
    return room


def drawn_rooms(text):
    """The rooms that stand side by side in a drawing: (start, goal, room) of each."""
    for rows in zip(*(line.split() for line in reversed(text.split("\n")) if line), strict=True):
        at = {(c, r): sign for r, row in enumerate(rows) for c, sign in enumerate(row)}
        (start,), (goal,) = ([cell for cell in at if at[cell] == sign] for sign in "SG")
        yield start, goal, {cell for cell in at if at[cell] != "#"}


@check("Straight and slanting", hint=0)
def open_floor(task):
    task.call(find_way, (3, 3), (6, 3), CELLS, gives=[(3, 3), (4, 3), (5, 3), (6, 3)])
    task.call(find_way, (3, 3), (5, 5), CELLS, gives=[(3, 3), (4, 4), (5, 5)])
    task.call(find_way, (4, 7), (4, 7), CELLS, gives=[(4, 7)])
    task.call(find_way, (3, 3), (4, 3), {(3, 3), (4, 3)}, gives=[(3, 3), (4, 3)])


@check("Round a wall", hint=2)
def wall(task):
    room = CELLS - {(10, row) for row in range(3, 18)}
    task.call(find_way, (8, 9), (12, 9), room)
    task.call(find_way, (8, 15), (12, 16), room)
    task.call(find_way, (0, 0), (19, 19), room)


@check("No route", hint=0)
def shut(task):
    room = CELLS - {(column, 9) for column in range(20)}
    task.call(find_way, (4, 4), (4, 15), room, gives=[])
    # Two rooms that touch at a corner alone: there a robot would cut the corner.
    corner = {(c, r) for c, r in CELLS if (c < 9 and r < 9) or (c >= 9 and r >= 9)}
    task.call(find_way, (8, 8), (9, 9), corner, gives=[])
    task.call(find_way, (2, 3), (15, 12), corner | {(9, 8)})


@check("Walls all about", hint=1)
def many(task):
    for walls in (5, 8, 11, 14, 17, 20):
        room = some_room(task, walls)
        start, goal = task.random.sample(sorted(room), 2)
        task.call(find_way, start, goal, room)


@check("The shortest, not only a short one", hint=1)
def shortest(task):
    for start, goal, room in chain(*map(drawn_rooms, (SMALL_ROOMS, LARGER_ROOMS, TWO_ROUTES))):
        task.call(find_way, start, goal, room)
    for share in (0.7, 0.8, 0.9):
        room = set(task.random.sample(sorted(CELLS), round(share * len(CELLS))))
        task.call(find_way, *task.random.sample(sorted(room), 2), room)


@check("Every step is allowed", hint=2)
def allowed_steps(task):
    for walls in (7, 10, 13):
        room = some_room(task, walls)
        task.call(through(room), *task.random.sample(sorted(room), 2), room)
