"""cell_of(x, y): the cell that holds a point, with cells of several sizes."""

from math import ceil, floor

from grader import calls, check, either, function, mistake, number, operator


def each(change):
    """What a mistake answers that treats x and y alike."""
    return lambda x, y: (change(x), change(y))


def down(value):
    return floor(value / 10)


CUT = (
    "int() cuts towards 0, so a point a little left of the mat, or below it, gets 0 where -1 is "
    "right; math.floor() always rounds down"
)
PUSHED = (
    "a point left of the mat was put into column 0: its column is -1 there, so leave negative "
    "numbers as they are"
)

cell_of = function(
    "cell_of(x, y)",
    each(down),
    cell_cm=10,
    mistakes=[
        (
            "column and row are the wrong way round: x decides the column, y decides the row",
            lambda x, y: (down(y), down(x)),
            0,
        ),
        (
            "rounded to the nearest whole number: a point in the upper half of a cell then gets "
            "the next cell; round down instead",
            each(lambda value: round(value / 10)),
            1,
        ),
        mistake(CUT, each(lambda value: int(value) // 10), 1, where=calls("int")),
        mistake(
            CUT,
            each(lambda value: int(value / 10)),
            1,
            where=calls("int"),
        ),
        mistake(
            CUT,
            lambda x, y: (down(x), int(y / 10)),
            1,
            where=calls("int"),
        ),
        mistake(
            CUT,
            lambda x, y: (int(x / 10), down(y)),
            1,
            where=calls("int"),
        ),
        (
            "not rounded down: 3.2 cells along means that the point is in column 3",
            each(lambda value: value / 10),
            1,
        ),
        mistake(
            "the numbers are right, but // makes a float of a float, 15.0 for example: "
            "math.floor() makes a whole number, 15",
            each(lambda value: value // 10),
            1,
            where=operator("//"),
        ),
        (
            "rounded down before dividing: divide by CELL first, then round down",
            each(lambda value: floor(value) / 10),
            1,
        ),
        ("the row comes from y: here both come from x", lambda x, y: (down(x),) * 2, 0),
        (
            "the column comes from x: here both come from y",
            lambda x, y: (down(y),) * 2,
            0,
        ),
        (
            "counted from 1: the cells at the left edge are column 0, those at the bottom row 0",
            each(lambda value: down(value) + 1),
            0,
        ),
        (
            "one too few: the cells at the left edge are column 0, those at the bottom row 0",
            each(lambda value: down(value) - 1),
            0,
        ),
        (
            "rounded up: a point anywhere inside a cell belongs to the line below it, so round "
            "down",
            each(lambda value: ceil(value / 10)),
            1,
        ),
        (
            "a point exactly on the line between two cells belongs to the right one or the upper "
            "one: math.floor() does that",
            each(lambda value: ceil(value / 10) - 1),
            1,
        ),
        mistake(
            "round() takes the even number where a value lies exactly between two, so points on "
            "the line between two cells go wrong: use math.floor()",
            each(lambda value: round(value / 10 - 0.5)),
            1,
            where=calls("round", "rint"),
        ),
        mistake(
            "multiplied by CELL: ask how many times 10 cm goes into x",
            each(lambda value: floor(value * 10)),
            0,
            where=operator("*"),
        ),
        mistake(
            "the remainder was taken: % says how far into its cell the point is, not which cell "
            "it is",
            each(lambda value: value % 10),
            0,
            where=either(operator("%"), calls("fmod", "divmod", "mod", "remainder")),
        ),
        (PUSHED, each(lambda value: max(0, down(value))), 1),
        (PUSHED, each(lambda value: min(19, max(0, down(value)))), 1),
        (
            "the minus sign was dropped: 3 cm left of the mat is in column -1, not in column 0",
            each(lambda value: down(abs(value))),
            1,
        ),
        mistake(
            "100 was taken away: here x and y count from the corner of the mat already",
            each(lambda value: down(value - 100)),
            0,
            where=number(100),
        ),
    ],
)


def with_cells_of(side):
    return function(
        "cell_of(x, y)",
        each(lambda value: floor(value / side)),
        cell_cm=side,
        mistakes=[
            mistake(
                "10 is typed in as the side of a cell: use CELL, so that it can change",
                each(down),
                2,
                where=number(10),
            )
        ],
    )


CELLS_OF_20, CELLS_OF_7 = with_cells_of(20), with_cells_of(7)


@check("A point well inside a cell", hint=0)
def inside(task):
    task.call(cell_of, 32, 74, gives=(3, 7))
    task.call(cell_of, 151.5, 23, gives=(15, 2))


@check("A point close to the next cell", hint=1)
def close(task):
    task.call(cell_of, 79.9, 28, gives=(7, 2))


@check("The corners of the mat, and points on the line between cells", hint=1)
def corners(task):
    task.call(cell_of, 0, 0, gives=(0, 0))
    task.call(cell_of, 199.9, 199.9, gives=(19, 19))
    task.call(cell_of, 60, 160, gives=(6, 16))
    task.call(cell_of, 50, 130, gives=(5, 13))


@check("Points a little left of the mat, and a little below it", hint=1)
def beyond(task):
    task.call(cell_of, -3, 12, gives=(-1, 1))
    task.call(cell_of, 45, -0.5, gives=(4, -1))
    task.call(cell_of, -10, -10.5, gives=(-1, -2))


@check("Many points", hint=1)
def many(task):
    for _ in range(30):
        x, y = (round(task.random.uniform(-20, 220), 1) for _ in range(2))
        task.call(cell_of, x, y)


@check("Cells of 20 cm", hint=2)
def another_size(task):
    task.set("CELL", 20)
    task.call(CELLS_OF_20, 32, 74, gives=(1, 3))
    task.call(CELLS_OF_20, 151.5, 23, gives=(7, 1))


@check("Cells of 7 cm", hint=2)
def odd_size(task):
    task.set("CELL", 7)
    task.call(CELLS_OF_7, 32, 74, gives=(4, 10))
    task.call(CELLS_OF_7, 6.9, 7, gives=(0, 1))
    task.call(CELLS_OF_7, -0.1, 195.9, gives=(-1, 27))
