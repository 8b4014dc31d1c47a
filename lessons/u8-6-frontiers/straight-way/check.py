"""straight_way(start, goal, walls): whether a robot can go straight without touching anything."""

from math import dist, floor

from grader import check, function
from mapping.frontiers import gap_to_walls
from mapping.grid import Grid

MAT = Grid(5)
SPARE = 6


def middles(walls):
    return [((column + 0.5) * 5, (row + 0.5) * 5) for column, row in walls]


def clear(start, goal, walls, spare=SPARE):
    return gap_to_walls(middles(walls), 5, start, goal) >= spare


def beyond(start, goal, share=3):
    return tuple(a + share * (b - a) for a, b in zip(start, goal))


def thin(start, goal, walls):
    """Only whether the line runs through a wall cell."""
    for i in range(201):
        x, y = (a + (b - a) * i / 200 for a, b in zip(start, goal))
        if (floor(x / 5), floor(y / 5)) in walls:
            return False
    return True


straight_way = function(
    "straight_way(start, goal, walls)",
    clear,
    mistakes=[
        (
            "the robot looks taken for a point: it must keep SPARE from every wall",
            thin,
            0,
        ),
        (
            "only the goal looks looked at: the way there must be clear too",
            lambda start, goal, walls: clear(goal, goal, walls),
            1,
        ),
        (
            "SPARE looks measured to the wall's middle: a wall cell reaches CELL / 2 further",
            lambda start, goal, walls: clear(start, goal, walls, SPARE - 2.5),
            0,
        ),
        (
            "the line goes on behind the goal: walls beyond the goal don't matter",
            lambda start, goal, walls: clear(start, beyond(start, goal), walls),
            1,
        ),
        (
            "true and false look swapped",
            lambda start, goal, walls: not clear(start, goal, walls),
            2,
        ),
        (
            "one clear point is not enough: every point of the line must be clear of every wall",
            lambda start, goal, walls: clear(start, start, walls) or clear(goal, goal, walls),
            2,
        ),
    ],
)


@check("A wall across the way, or none", hint=1)
def across(task):
    wall = {(column, 24) for column in range(12, 28)}
    task.call(straight_way, (100, 25), (100, 180), wall, gives=False)
    task.call(straight_way, (100, 25), (100, 100), wall, gives=True)
    task.call(straight_way, (20, 25), (20, 180), wall, gives=True)
    task.call(straight_way, (100, 25), (100, 100), set(), gives=True)


@check("Along a wall", hint=0)
def along(task):
    wall = {(20, row) for row in range(10, 30)}  # from x = 100 to 105
    task.call(straight_way, (93, 20), (93, 180), wall, gives=True)
    task.call(straight_way, (95, 20), (95, 180), wall, gives=False)
    task.call(straight_way, (112, 20), (112, 180), wall, gives=True)
    task.call(straight_way, (108, 20), (108, 180), wall, gives=False)


@check("Through a doorway", hint=2)
def doorway(task):
    walls = {(column, 24) for column in range(40) if not 18 <= column < 22}
    task.call(straight_way, (100, 60), (100, 180), walls, gives=True)
    task.call(straight_way, (94, 60), (94, 180), walls, gives=False)
    task.call(straight_way, (60, 100), (140, 150), walls, gives=False)


@check("Boxes all about", hint=2)
def many(task):
    asked = 0
    while asked < 30:
        walls = set()
        for _ in range(6):
            column, row = task.random.randrange(37), task.random.randrange(37)
            walls |= {(column + i, row + j) for i in range(3) for j in range(2)}
        start, goal = (
            (round(task.random.uniform(10, 190), 1), round(task.random.uniform(10, 190), 1))
            for _ in range(2)
        )
        gap = gap_to_walls(middles(walls), 5, start, goal)
        if abs(gap - SPARE) > 0.3 and dist(start, goal) > 10:  # not for the last millimetre
            task.call(straight_way, start, goal, walls)
            asked += 1
