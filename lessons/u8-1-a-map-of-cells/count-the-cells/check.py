"""count_cells(side): how many square cells cover the mat of 200 cm."""

from math import ceil, floor

from bugbot.frames import cells_across
from grader import check, function

count_cells = function(
    "count_cells(side)",
    lambda side: cells_across(side) ** 2,
    mistakes=[
        (
            "rounded down: that leaves a strip of bare mat at the far edges; the last cell may "
            "hang over",
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
            "rounded to the nearest whole number: a small rest needs one more cell too; round up",
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
            "not a whole number: round up how many fit along one edge before you multiply",
            lambda side: (200 / side) ** 2,
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
def with_a_rest(task):
    task.call(count_cells, 30, gives=49)
    task.call(count_cells, 150, gives=4)
    task.call(count_cells, 7, gives=841)


@check("Many sizes", hint=2)
def many(task):
    for _ in range(20):
        task.call(count_cells, task.random.randint(3, 199))
