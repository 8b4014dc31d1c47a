"""centre_of(column, row): the middle of a cell in cm, with cells of 10 cm."""

from bugbot.frames import cell_centre
from grader import check, function, near

centre_of = function(
    "centre_of(column, row)",
    lambda column, row: cell_centre(column, row, 10),
    compare=near(0.001, "cm"),
    mistakes=[
        (
            "that is the lower left corner of the cell: the middle is half a cell further, both "
            "ways",
            lambda column, row: (column * 10, row * 10),
            1,
        ),
        (
            "column and row look swapped: the column decides x, the row decides y",
            lambda column, row: cell_centre(row, column, 10),
            0,
        ),
        (
            "half a centimetre was added, not half a cell: add the half before you multiply by "
            "CELL",
            lambda column, row: (column * 10 + 0.5, row * 10 + 0.5),
            2,
        ),
        (
            "that is the upper right corner of the cell: a whole cell was added instead of half",
            lambda column, row: ((column + 1) * 10, (row + 1) * 10),
            1,
        ),
        (
            "counted from 1: column 0 is the first, and its middle is half a cell from the left "
            "edge",
            lambda column, row: ((column - 0.5) * 10, (row - 0.5) * 10),
            1,
        ),
        (
            "divided by CELL: a cell is 10 cm wide, so its number has to be multiplied",
            lambda column, row: ((column + 0.5) / 10, (row + 0.5) / 10),
            0,
        ),
    ],
)

centre_of_4 = function(
    "centre_of(column, row)",
    lambda column, row: cell_centre(column, row, 4),
    compare=near(0.001, "cm"),
    mistakes=[
        (
            "the side of a cell looks written as a number: use CELL, so that it can change",
            lambda column, row: cell_centre(column, row, 10),
            2,
        ),
        (
            "half of 10 cm looks written as a number: half a cell is CELL / 2",
            lambda column, row: (column * 4 + 5, row * 4 + 5),
            2,
        ),
    ],
)


@check("The cell in the lower left corner", hint=1)
def corner(task):
    task.call(centre_of, 0, 0, gives=(5, 5))


@check("Cells further along and further up", hint=0)
def further(task):
    task.call(centre_of, 3, 7, gives=(35, 75))
    task.call(centre_of, 19, 0, gives=(195, 5))
    for _ in range(10):
        task.call(centre_of, task.random.randrange(20), task.random.randrange(20))


@check("Cells of another size", hint=2)
def another_size(task):
    task.set("CELL", 4)
    task.call(centre_of_4, 3, 7, gives=(14, 30))
    task.call(centre_of_4, 49, 12, gives=(198, 50))
