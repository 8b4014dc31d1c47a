"""centre_of(column, row): the middle of a cell in cm, with cells of several sizes."""

from bugbot.frames import cell_centre
from grader import calls, check, code, either, function, mistake, near, number, operator


def each(change):
    """What a mistake answers that treats column and row alike."""
    return lambda column, row: (change(column), change(row))


def one_axis(text, change, hint, side=10, where=()):
    """The mistake of an axis that goes by `change`, while the other one is right."""

    def right(number):
        return (number + 0.5) * side

    return (
        mistake(
            f"x is right, y is not: {text}",
            lambda column, row: (right(column), change(row)),
            hint,
            where=where,
        ),
        mistake(
            f"y is right, x is not: {text}",
            lambda column, row: (change(column), right(row)),
            hint,
            where=where,
        ),
    )


def with_cells_of(side, mistakes):
    return function(
        "centre_of(column, row)",
        lambda column, row: cell_centre(column, row, side),
        compare=near(0.001, "cm"),
        mistakes=mistakes,
    )


BRACKETS = "only the half was multiplied by CELL; put brackets round the sum"

HALF_DROPPED = (
    "the half centimetre is missing: half of 7 cm is 3.5 cm, and //, int(), round() and "
    "math.ceil() make a whole number of it; divide with /"
)

centre_of = with_cells_of(
    10,
    [
        (
            "that is the lower left corner of the cell: the middle is half a cell further to the "
            "right and half a cell further up",
            each(lambda number: number * 10),
            1,
        ),
        (
            "column and row are the wrong way round: the column decides x, the row decides y",
            lambda column, row: cell_centre(row, column, 10),
            0,
        ),
        (
            "y comes from the row: here both come from the column",
            lambda column, row: cell_centre(column, column, 10),
            0,
        ),
        (
            "half a centimetre was added, not half a cell: add the half before you multiply by "
            "CELL",
            each(lambda number: number * 10 + 0.5),
            2,
        ),
        (
            "the number of the cell was not multiplied by CELL, only the half was: put brackets "
            "round the sum, (column + 0.5) * CELL",
            each(lambda number: number + 5),
            2,
        ),
        mistake(
            "the cell's beginning was halved as well: add 0.5, not 1, and don't halve the rest",
            each(lambda number: (number * 10 + 10) / 2),
            2,
            where=code("_ + 1", "1 + _"),
        ),
        (
            "the cell's beginning was halved as well: only the last CELL in the sum is to be "
            "halved, column * CELL + CELL / 2",
            each(lambda number: (number * 10 + 10) / 2),
            2,
        ),
        (
            "that is the upper right corner of the cell: a complete cell was added, not half of "
            "one",
            each(lambda number: (number + 1) * 10),
            1,
        ),
        (
            "a whole cell too low: columns count from 0, so the middle of column 0 is half a cell "
            "to the right of x = 0",
            each(lambda number: (number - 0.5) * 10),
            1,
        ),
        mistake(
            "divided by CELL: a cell is 10 cm wide, so its number has to be multiplied",
            each(lambda number: (number + 0.5) / 10),
            0,
            where=operator("/", "//"),
        ),
        (
            "y was counted from the top: rows count from the bottom of the mat, and so does y",
            lambda column, row: (column * 10 + 5, 195 - row * 10),
            0,
        ),
        *one_axis(
            "that is the edge of the cell, and its middle is half a cell further",
            lambda number: number * 10,
            1,
        ),
        *one_axis(BRACKETS, lambda number: number + 5, 2),
        *one_axis(
            "half a centimetre was added, not half a cell",
            lambda number: number * 10 + 0.5,
            2,
        ),
        *one_axis(
            "a complete cell was added, not half of one", lambda number: (number + 1) * 10, 1
        ),
        mistake(
            "a centimetre was taken off the far edge: a cell reaches from column * CELL to "
            "(column + 1) * CELL",
            each(lambda number: number * 10 + 4.5),
            1,
            where=number(1),
        ),
    ],
)

TYPED_IN = "10 is typed in as the side of a cell: use CELL, so that it can change"
HALF_TYPED_IN = "5 is typed in as half a cell: use CELL / 2, so that it can change"

CELLS_OF_7 = with_cells_of(
    7,
    [
        mistake(
            TYPED_IN,
            lambda column, row: cell_centre(column, row, 10),
            2,
            where=number(10),
        ),
        mistake(
            HALF_TYPED_IN,
            each(lambda number: number * 7 + 5),
            2,
            where=number(5),
        ),
        *one_axis(HALF_TYPED_IN, lambda number: number * 7 + 5, 2, side=7, where=number(5)),
        *one_axis(
            HALF_DROPPED,
            lambda number: number * 7 + 3,
            1,
            side=7,
            where=either(operator("//"), calls("int", "round", "floor")),
        ),
        mistake(
            HALF_DROPPED,
            each(lambda number: number * 7 + 3),
            1,
            where=either(operator("//"), calls("int", "round", "floor")),
        ),
        mistake(
            HALF_DROPPED,
            each(lambda number: number * 7 + 4),
            1,
            where=either(operator("//"), calls("int", "round", "ceil")),
        ),
        mistake(
            HALF_DROPPED,
            each(lambda number: round((number + 0.5) * 7)),
            1,
            where=either(operator("//"), calls("int", "round", "floor")),
        ),
    ],
)
CELLS_OF_2_5 = with_cells_of(
    2.5,
    [
        mistake(
            TYPED_IN,
            lambda column, row: cell_centre(column, row, 10),
            2,
            where=number(10),
        ),
        mistake(
            HALF_TYPED_IN,
            each(lambda number: number * 2.5 + 5),
            2,
            where=number(5),
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


@check("Cells of 7 cm", hint=2)
def odd_size(task):
    task.set("CELL", 7)
    task.call(CELLS_OF_7, 3, 7, gives=(24.5, 52.5))
    task.call(CELLS_OF_7, 27, 12, gives=(192.5, 87.5))
    task.call(CELLS_OF_7, 0, 1, gives=(3.5, 10.5))


@check("Cells of 2.5 cm", hint=2)
def small(task):
    task.set("CELL", 2.5)
    task.call(CELLS_OF_2_5, 3, 7, gives=(8.75, 18.75))
    task.call(CELLS_OF_2_5, 79, 0, gives=(198.75, 1.25))
