"""count_cells(side): how many square cells cover the mat of 200 cm."""

from math import ceil, floor

from bugbot.frames import cells_across
from grader import calls, check, function, lacks, mistake, near, operator, reads

count_cells = function(
    "count_cells(side)",
    lambda side: cells_across(side) ** 2,
    compare=near(1e-9),  # 400.0 cells are 400 cells
    mistakes=[
        (
            "rounded down: that leaves a strip of bare mat at the far edges; the last cell may "
            "hang over the edge, so round up",
            lambda side: floor(200 / side) ** 2,
            1,
        ),
        (
            "that is only one row of cells: the mat has as many rows as columns",
            lambda side: ceil(200 / side),
            0,
        ),
        (
            "the areas were divided: cells can't be cut up and laid elsewhere, so count along one "
            "edge first",
            lambda side: ceil(200 * 200 / side**2),
            0,
        ),
        (
            "rounded to the nearest whole number: a small remainder needs one more cell too, so "
            "round up",
            lambda side: round(200 / side) ** 2,
            1,
        ),
        (
            "one cell too many along each edge where they fit exactly: 20 cells of 10 cm make 200 "
            "cm",
            lambda side: (int(200 / side) + 1) ** 2,
            1,
        ),
        (
            "one row too few where the cells don't fit exactly: there are as many rows as columns, "
            "so round up in both directions",
            lambda side: ceil(200 / side) * floor(200 / side),
            1,
        ),
        mistake(
            "never rounded: round up how many cells fit along one edge before you multiply",
            lambda side: (200 / side) ** 2,
            1,
            where=lacks(calls("ceil", "round", "floor", "int")),
        ),
        (
            "doubled: there are as many rows as columns, so multiply the number along one edge by "
            "itself",
            lambda side: 2 * ceil(200 / side),
            0,
        ),
        mistake(
            "in Python ^ is not a power: write across ** 2 or across * across",
            lambda side: ceil(200 / side) ^ 2,
            2,
            where=operator("^"),
        ),
        mistake(
            "SIDE was used in place of side: the function must answer for the side it is given",
            lambda side: 49,
            1,
            where=reads("SIDE"),
        ),
        (
            "the division is upside down: ask how many times the side goes into 200 cm",
            lambda side: ceil(side / 200) ** 2,
            1,
        ),
    ],
)


@check("Cells that fit exactly", hint=0)
def exact(task):
    task.call(count_cells, 10, gives=400)
    task.call(count_cells, 5, gives=1600)
    task.call(count_cells, 25, gives=64)


@check("One cell as large as the mat", hint=0)
def one(task):
    task.call(count_cells, 200, gives=1)


@check("Cells that don't fit exactly", hint=1)
def with_a_remainder(task):
    task.call(count_cells, 30, gives=49)
    task.call(count_cells, 150, gives=4)
    task.call(count_cells, 7, gives=841)


@check("Many sizes", hint=2)
def many(task):
    for _ in range(20):
        task.call(count_cells, task.random.randint(3, 199))
