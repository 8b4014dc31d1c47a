"""straight_way(start, goal, walls): whether a robot can go straight without touching anything."""

from math import dist, floor, hypot

from grader import check, function, mistake, number
from mapping.frontiers import gap_to_walls

SPARE = 6


def middles(walls, cell=5):
    return [((column + 0.5) * cell, (row + 0.5) * cell) for column, row in walls]


def clear(start, goal, walls, spare=SPARE, cell=5):
    return gap_to_walls(middles(walls, cell), cell, start, goal) >= spare


def beyond(start, goal, share=3):
    return tuple(a + share * (b - a) for a, b in zip(start, goal))


def along(start, goal, count):
    return [beyond(start, goal, i / count) for i in range(count + 1)]


def every_cm(start, goal):
    return along(start, goal, floor(dist(start, goal)) + 1)


def gap_to_square(point, cell):
    """How far a point is from a cell of 5 cm."""
    return hypot(*(max(5 * c - x, 0, x - 5 * c - 5) for x, c in zip(point, cell, strict=True)))


def in_steps(count):
    """Points that are too far apart on a long line."""
    return lambda start, goal, walls: all(
        dist(point, middle) - 2.5 >= SPARE
        for point in along(start, goal, count)
        for middle in middles(walls)
    )


def of(spare, mistakes, cell=5):
    return function(
        "straight_way(start, goal, walls)",
        lambda start, goal, walls: clear(start, goal, walls, spare, cell),
        leaves=True,
        mistakes=mistakes,
    )


straight_way = of(
    SPARE,
    [
        (
            "the robot was taken for a point: it must keep SPARE from every wall",
            lambda start, goal, walls: all(
                (floor(x / 5), floor(y / 5)) not in walls for x, y in every_cm(start, goal)
            ),
            0,
        ),
        (
            "only the goal is looked at: all points on the line to it must be clear too",
            lambda start, goal, walls: clear(goal, goal, walls),
            1,
        ),
        (
            "the start is left out: the robot needs SPARE cm to every wall there too",
            lambda start, goal, walls: clear(
                beyond(start, goal, 1 / (floor(dist(start, goal)) + 1)), goal, walls
            ),
            1,
        ),
        (
            "walls were taken for squares: a wall cell counts as a disc, CELL / 2 round its middle",
            lambda start, goal, walls: all(
                gap_to_square(point, cell) >= SPARE
                for point in every_cm(start, goal)
                for cell in walls
            ),
            0,
        ),
        (
            "one clear point is not enough: every point of the line must be clear of every wall",
            lambda start, goal, walls: any(
                clear(point, point, walls) for point in every_cm(start, goal)
            ),
            2,
        ),
        (
            "only the start is looked at: all points up to the goal must be clear too",
            lambda start, goal, walls: clear(start, start, walls),
            2,
        ),
        (
            "only both ends are looked at: all points between them must be clear too",
            lambda start, goal, walls: clear(start, start, walls) and clear(goal, goal, walls),
            1,
        ),
        (
            "SPARE was measured to the wall's middle: a wall cell reaches CELL / 2 further",
            lambda start, goal, walls: clear(start, goal, walls, SPARE - 2.5),
            0,
        ),
        (
            "the gap came out CELL / 2 too small: it is the distance to the middle, less CELL / 2",
            lambda start, goal, walls: clear(start, goal, walls, SPARE + 2.5),
            0,
        ),
        (
            "the distance is to the lower left corner of a cell: its middle is half a cell further",
            lambda start, goal, walls: (
                gap_to_walls([(5 * c, 5 * r) for c, r in walls], 5, start, goal) >= SPARE
            ),
            0,
        ),
        (
            "the line goes on behind the goal: walls beyond the goal don't matter",
            lambda start, goal, walls: clear(start, beyond(start, goal), walls),
            1,
        ),
        (
            "True and False are the wrong way round",
            lambda start, goal, walls: not clear(start, goal, walls),
            2,
        ),
        *(
            (
                "the points are too far apart on a long line: 1 cm at most, so their number "
                "depends on its length",
                in_steps(count),
                1,
            )
            for count in (5, 10, 20, 25, 50)
        ),
        (
            "columns and rows are the wrong way round: x goes with the column, y with the row",
            lambda start, goal, walls: clear(start, goal, {(r, c) for c, r in walls}),
            0,
        ),
    ],
)
wide = of(
    11,
    [
        mistake(
            "6 was typed in: SPARE says how far the robot keeps from walls",
            lambda start, goal, walls: clear(start, goal, walls, 6),
            0,
            where=number(6),
        ),
    ],
)


coarse = of(
    SPARE,
    [
        (
            "5 was typed in: CELL says how wide a cell is",
            lambda start, goal, walls: clear(start, goal, walls),
            0,
        ),
    ],
    cell=20,
)


@check("A wall across the route, or none", hint=1)
def across(task):
    wall = {(column, 24) for column in range(12, 28)}
    task.call(straight_way, (100, 25), (100, 180), wall, gives=False)
    task.call(straight_way, (100, 25), (100, 100), wall, gives=True)
    task.call(straight_way, (20, 25), (20, 180), wall, gives=True)
    task.call(straight_way, (100, 25), (100, 100), set(), gives=True)


@check("Along a wall", hint=0)
def beside(task):
    wall = {(20, row) for row in range(10, 30)}  # from x = 100 to 105
    task.call(straight_way, (93, 20), (93, 180), wall, gives=True)
    task.call(straight_way, (95, 20), (95, 180), wall, gives=False)
    task.call(straight_way, (112, 20), (112, 180), wall, gives=True)
    task.call(straight_way, (108, 20), (108, 180), wall, gives=False)


@check("A gap of exactly SPARE, and a little less", hint=0)
def just(task):
    # The goal is straight below a wall cell's middle, 8.5 cm away from it.
    task.call(straight_way, (20, 94), (102.5, 94), {(20, 20)}, gives=True)
    task.call(straight_way, (20, 94.1), (102.5, 94.1), {(20, 20)}, gives=False)


@check("A wall just before the goal, or just behind it", hint=1)
def at_the_goal(task):
    # The wall cell's middle is at (102.5, 102.5), so x = 94 is exactly SPARE away from it.
    task.call(straight_way, (60.3, 102.5), (94.1, 102.5), {(20, 20)}, gives=False)
    task.call(straight_way, (60.3, 102.5), (93.9, 102.5), {(20, 20)}, gives=True)
    task.call(straight_way, (102.5, 144.7), (102.5, 110.9), {(20, 20)}, gives=False)
    task.call(straight_way, (93.5, 102.5), (94.1, 102.5), {(20, 20)}, gives=False)
    task.call(straight_way, (93.3, 102.5), (93.9, 102.5), {(20, 20)}, gives=True)


@check("A wall just before the start", hint=1)
def at_the_start(task):
    # The first point is 8.4 cm from the wall's middle, and then 8.6 cm: only 8.5 cm are wanted.
    task.call(straight_way, (102.5, 94.1), (102.5, 60.3), {(20, 20)}, gives=False)
    task.call(straight_way, (102.5, 93.9), (102.5, 60.3), {(20, 20)}, gives=True)


@check("Points at most 1 cm apart, and walls that are discs", hint=1)
def steps_and_discs(task):
    # Both ends are far enough away, the point between them is not.
    task.call(straight_way, (101.8, 94.021), (103.2, 94.021), {(20, 20)}, gives=False)
    # Past the corner of a cell: 8.98 cm from its middle.
    task.call(straight_way, (76.1, 116.2), (116.2, 76.1), {(20, 20)}, gives=True)


@check("Through a doorway", hint=2)
def doorway(task):
    walls = {(column, 24) for column in range(40) if not 18 <= column < 22}
    task.call(straight_way, (100, 60), (100, 180), walls, gives=True)
    task.call(straight_way, (94, 60), (94, 180), walls, gives=False)
    task.call(straight_way, (60, 100), (140, 150), walls, gives=False)


@check("Past a post", hint=1)
def post(task):
    # 0.05 cm too near: points at most 1 cm apart find it wherever they lie.
    for _ in range(12):
        x, end = task.random.uniform(8, 30), task.random.uniform(160, 190)
        column = task.random.randrange(12, 26)
        task.call(straight_way, (x, 94.05), (end, 94.05), {(column, 20)}, gives=False)


def some_line(task, spare):
    """A line among boxes that misses the limit by more than a hair."""
    while True:
        walls = set()
        for _ in range(6):
            column, row = task.random.randrange(37), task.random.randrange(37)
            walls |= {(column + i, row + j) for i in range(3) for j in range(2)}
        start, goal = (
            (round(task.random.uniform(10, 190), 1), round(task.random.uniform(10, 190), 1))
            for _ in range(2)
        )
        gap = gap_to_walls(middles(walls), 5, start, goal)
        if abs(gap - spare) > 0.1 and dist(start, goal) > 10:
            return start, goal, walls


@check("Boxes all about", hint=2)
def many(task):
    for _ in range(30):
        task.call(straight_way, *some_line(task, SPARE))


@check("A wider robot", hint=0)
def wider(task):
    task.set("SPARE", 11)
    wall = {(20, row) for row in range(10, 30)}  # from x = 100 to 105
    task.call(wide, (93, 20), (93, 180), wall, gives=False)
    task.call(wide, (88, 20), (88, 180), wall, gives=True)
    for _ in range(10):
        task.call(wide, *some_line(task, 11))


@check("Cells of 20 cm", hint=0)
def larger_cells(task):
    task.set("CELL", 20)
    # The wall cell is a disc of 10 cm round (90, 110): 16 cm are wanted from its middle.
    task.call(coarse, (20, 93), (180, 93), {(4, 5)}, gives=True)
    task.call(coarse, (20, 95), (180, 95), {(4, 5)}, gives=False)
    task.call(coarse, (73, 20), (73, 180), {(4, 5)}, gives=True)
    task.call(coarse, (75, 20), (75, 180), {(4, 5)}, gives=False)
