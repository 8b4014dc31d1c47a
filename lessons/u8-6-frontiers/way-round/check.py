"""find_way(start, goal, room): a shortest route; any that is as short is right."""

from heapq import heappop, heappush
from itertools import pairwise
from math import dist

from grader import check, exactly, function
from mapping.grid import Grid
from mapping.planning import shortest_way

MAT = Grid(10)
SIDES = [(-1, 0), (1, 0), (0, -1), (0, 1)]
CORNERS = [(-1, -1), (1, -1), (-1, 1), (1, 1)]
CELLS = {MAT.cell(index) for index in range(len(MAT.cells))}


def reference(start, goal, room):
    way = shortest_way(MAT, MAT.index(start), MAT.index(goal), set(map(MAT.index, room)))
    return [MAT.cell(index) for index in way]


def as_short(expected, got):
    """Whether it is a route from start to goal, step by step, and no longer."""
    if isinstance(expected, dict):
        return _right_once_mended(expected, got)
    if not isinstance(expected, list):
        return exactly(expected, got)  # no list of cells: a mistake's answer
    if not isinstance(got, list | tuple) or not all(_is_cell(each) for each in got):
        return False
    if not expected or not got:
        return not expected and not got
    steps = [dist(a, b) for a, b in pairwise(got)]
    shortest = sum(dist(a, b) for a, b in pairwise(expected))
    return (
        tuple(got[0]) == expected[0]
        and tuple(got[-1]) == expected[-1]
        and all(0 < step < 1.5 for step in steps)
        and abs(sum(steps) - shortest) < 1e-6
    )


def _right_once_mended(slip, got):
    """Whether it is a route but for one mistake; of several routes it may be any."""
    if not isinstance(got, list | tuple):
        return False
    if not slip["route"]:
        return not got
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


def _is_cell(value):
    return (
        isinstance(value, list | tuple) and len(value) == 2 and all(type(n) is int for n in value)
    )


def through(room):
    """The same question, asked of each step too: each must be allowed in this room."""

    def allowed(expected, got):
        if not as_short(expected, got) or not isinstance(expected, list):
            return as_short(expected, got)
        return all({tuple(b), (b[0], a[1]), (a[0], b[1])} <= room for a, b in pairwise(got))

    return function("find_way(start, goal, room)", reference, compare=allowed, cell_cm=10)


def search(start, goal, room, steps, cost=dist, cuts=False):
    """A mistake in it: other steps, other costs, or corners cut (True, or "one")."""
    length, before, waiting = {start: 0}, {start: None}, [(0, start)]
    while waiting:
        so_far, cell = heappop(waiting)
        if cell == goal:
            way = []
            while cell:
                way.append(cell)
                cell = before[cell]
            return way[::-1]
        for c, r in steps:
            new = cell[0] + c, cell[1] + r
            both = [(new[0], cell[1]) in room, (cell[0], new[1]) in room]
            round_it = all(both) if not cuts else any(both) or cuts is True
            if new in room and round_it and so_far + cost(cell, new) < length.get(new, 1e9):
                length[new], before[new] = so_far + cost(cell, new), cell
                heappush(waiting, (length[new], new))
    return []


find_way = function(
    "find_way(start, goal, room)",
    reference,
    compare=as_short,
    cell_cm=10,
    mistakes=[
        (
            "it cuts corners: a step to a corner needs room on both cells beside it",
            lambda start, goal, room: search(start, goal, room, SIDES + CORNERS, cuts=True),
            2,
        ),
        (
            "it cuts corners: both cells beside a step to a corner need room, not one of them",
            lambda start, goal, room: search(start, goal, room, SIDES + CORNERS, cuts="one"),
            2,
        ),
        (
            "only steps to the sides were taken: a step to a corner is shorter than two of them",
            lambda start, goal, room: search(start, goal, room, SIDES),
            2,
        ),
        (
            "a step to a corner was counted as 1: it is the square root of 2, dist(cell, new)",
            lambda start, goal, room: search(
                start, goal, room, SIDES + CORNERS, cost=lambda a, b: 1
            ),
            1,
        ),
        (
            "it goes through cells without room: a step leads to a cell of room",
            lambda start, goal, room: search(start, goal, CELLS, SIDES + CORNERS),
            2,
        ),
        (
            "the list begins at the goal: walking back from the goal gives it the wrong way round",
            but_for(turned=True),
            0,
        ),
        (
            "the start is missing: the list begins with it",
            but_for(first=True),
            0,
        ),
        (
            "the goal is missing: the list ends with it",
            but_for(last=True),
            0,
        ),
        (
            "start and goal are all there is: the cells between them belong to the list too",
            lambda start, goal, room: [start, goal],
            0,
        ),
        (
            "that is how long the route is: the cells are wanted",
            lambda start, goal, room: (
                sum(dist(a, b) for a, b in pairwise(reference(start, goal, room)))
                if reference(start, goal, room)
                else []
            ),
            0,
        ),
    ],
)


def some_room(task, walls):
    room = set(CELLS)
    for _ in range(walls):
        column, row = task.random.randrange(20), task.random.randrange(20)
        long = task.random.randrange(3, 9)
        room -= {(column + i, row) if walls % 2 else (column, row + i) for i in range(long)}
        column, row = task.random.randrange(20), task.random.randrange(20)
        room -= {(column, row + i) for i in range(long)}
    return room


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


@check("Every step is allowed", hint=2)
def allowed_steps(task):
    for walls in (7, 10, 13):
        room = some_room(task, walls)
        task.call(through(room), *task.random.sample(sorted(room), 2), room)
