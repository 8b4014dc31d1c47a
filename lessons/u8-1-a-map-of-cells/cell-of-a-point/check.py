"""cell_of(x, y): the cell that holds a point, with cells of 10 cm."""

from math import ceil, floor

from grader import check, function

SWAPPED = "column and row look swapped: x decides the column, y decides the row"

cell_of = function(
    "cell_of(x, y)",
    lambda x, y: (floor(x / 10), floor(y / 10)),
    cell_cm=10,
    mistakes=[
        (SWAPPED, lambda x, y: (floor(y / 10), floor(x / 10)), 0),
        (
            "rounded to the nearest whole number: a point in the upper half of a cell then gets "
            "the next one; round down instead",
            lambda x, y: (round(x / 10), round(y / 10)),
            1,
        ),
        (
            "int() cuts towards 0, so a little left of the mat looks like column 0; math.floor() "
            "always goes down",
            lambda x, y: (int(x / 10), int(y / 10)),
            1,
        ),
        (
            "not rounded down: 3.2 cells along means that the point is in column 3",
            lambda x, y: (x / 10, y / 10),
            1,
        ),
        (
            "counted from 1: the cells at the left edge are column 0, those at the bottom row 0",
            lambda x, y: (floor(x / 10) + 1, floor(y / 10) + 1),
        ),
        (
            "rounded up: a point anywhere inside a cell belongs to the line below it, so round "
            "down",
            lambda x, y: (ceil(x / 10), ceil(y / 10)),
            1,
        ),
        (
            "multiplied by CELL: ask how many times 10 cm goes into x",
            lambda x, y: (floor(x * 10), floor(y * 10)),
            0,
        ),
    ],
)

cell_of_20 = function(
    "cell_of(x, y)",
    lambda x, y: (floor(x / 20), floor(y / 20)),
    cell_cm=20,
    mistakes=[
        (
            "the side of a cell looks written as a number: use CELL, so that it can change",
            lambda x, y: (floor(x / 10), floor(y / 10)),
            2,
        )
    ],
)


@check("A point well inside a cell", hint=0)
def inside(task):
    task.call(cell_of, 32, 74, gives=(3, 7))
    task.call(cell_of, 151.5, 23, gives=(15, 2))


@check("A point close to the next cell", hint=1)
def close(task):
    task.call(cell_of, 79.9, 28, gives=(7, 2))


@check("The corners of the mat, and a point on the line between cells", hint=1)
def corners(task):
    task.call(cell_of, 0, 0, gives=(0, 0))
    task.call(cell_of, 199.9, 199.9, gives=(19, 19))
    task.call(cell_of, 60, 160, gives=(6, 16))


@check("Points a little left of the mat, and a little below it", hint=1)
def beyond(task):
    task.call(cell_of, -3, 12, gives=(-1, 1))
    task.call(cell_of, 45, -0.5, gives=(4, -1))


@check("Many points", hint=1)
def many(task):
    for _ in range(30):
        x, y = (round(task.random.uniform(-20, 220), 1) for _ in range(2))
        task.call(cell_of, x, y)


@check("Cells of another size", hint=2)
def another_size(task):
    task.set("CELL", 20)
    task.call(cell_of_20, 32, 74, gives=(1, 3))
    task.call(cell_of_20, 151.5, 23, gives=(7, 1))
