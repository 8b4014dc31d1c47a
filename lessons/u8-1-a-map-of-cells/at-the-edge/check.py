"""index_of(x, y): the index in the list of a point's cell, None beyond the mat."""

from math import floor

from grader import calls, check, code, function, mistake, number, operator, reads


def index_on_mat(x, y, holds=None, side=10, across=20, else_=None):
    """The index where `holds(column, row)`, else `else_`."""
    column, row = floor(x / side), floor(y / side)
    on_the_mat = 0 <= column < across and 0 <= row < across if holds is None else holds(column, row)
    return row * across + column if on_the_mat else else_


def where_cell(holds):
    """What a mistake answers that lets other cells through."""
    return lambda x, y: index_on_mat(x, y, holds)


def where_point(holds):
    """What a mistake answers that lets other points through."""
    return lambda x, y: index_on_mat(x, y, lambda column, row: holds(x, y))


def by_parts(part):
    """What a mistake answers that makes column and row whole numbers in another way."""

    def answer(x, y):
        column, row = part(x), part(y)
        return row * 20 + column if 0 <= column < 20 and 0 <= row < 20 else None

    return answer


def changed(index):
    """What a mistake answers that lets the right points through and gives another index."""

    def answer(x, y):
        right = index_on_mat(x, y)
        return None if right is None else index(right % 20, right // 20)

    return answer


index_of = function(
    "index_of(x, y)",
    index_on_mat,
    mistakes=[
        (
            "column and row are the wrong way round: the list goes row after row, so it is "
            "row * ACROSS + column",
            changed(lambda column, row: column * 20 + row),
            0,
        ),
        (
            "the row comes from y: here both come from x",
            lambda x, y: index_on_mat(x, x),
            0,
        ),
        (
            "the column comes from x: here both come from y",
            lambda x, y: index_on_mat(y, y),
            0,
        ),
        (
            "nothing keeps points beyond the mat out: each must give None",
            where_cell(lambda column, row: True),
            1,
        ),
        (
            "a negative column or row got through: points left of the mat and below it have no "
            "cell",
            where_cell(lambda column, row: column < 20 and row < 20),
            1,
        ),
        (
            "a column or row of 20 or more got through: points right of the mat and above it have "
            "no cell",
            where_cell(lambda column, row: column >= 0 and row >= 0),
            1,
        ),
        (
            "a column or row of 20 got through: counted from 0, the last column is ACROSS - 1",
            where_cell(lambda column, row: 0 <= column <= 20 and 0 <= row <= 20),
            1,
        ),
        mistake(
            "x = 200 and y = 200 are beyond the mat: the comparison there must be <, not <=",
            where_point(lambda x, y: 0 <= x <= 200 and 0 <= y <= 200),
            1,
            where=operator("<="),
        ),
        (
            "x = 200 and y = 200 are beyond the mat: from 200 on there is no cell",
            where_point(lambda x, y: 0 <= x <= 200 and 0 <= y <= 200),
            1,
        ),
        (
            "column 0 and row 0 are on the mat: 0 must pass the check",
            where_cell(lambda column, row: 0 < column < 20 and 0 < row < 20),
            1,
        ),
        mistake(
            "x = 0 and y = 0 are on the mat: the comparison there must be <=, not <",
            where_point(lambda x, y: 0 < x < 200 and 0 < y < 200),
            1,
            where=operator("<"),
        ),
        (
            "x = 0 and y = 0 are on the mat: they belong to column 0 and row 0",
            where_point(lambda x, y: 0 < x < 200 and 0 < y < 200),
            1,
        ),
        (
            "the last column and the last row are on the mat: they have the number 19, which is "
            "below ACROSS",
            where_cell(lambda column, row: 0 <= column < 19 and 0 <= row < 19),
            1,
        ),
        (
            "only the index was checked: right of the mat that is the first cell of the next row; "
            "check column and row one by one",
            where_cell(lambda column, row: 0 <= row * 20 + column < 400),
            1,
        ),
        (
            "only the column was checked: above and below the mat there are no cells either",
            where_cell(lambda column, row: 0 <= column < 20),
            1,
        ),
        (
            "only the row was checked: left and right of the mat there are no cells either",
            where_cell(lambda column, row: 0 <= row < 20),
            1,
        ),
        (
            "one of the two was enough here: a point is on the mat only if its column and its row "
            "are, so join them with and",
            where_cell(lambda column, row: 0 <= column < 20 or 0 <= row < 20),
            1,
        ),
        (
            "ACROSS counts cells, but x and y are in cm: compare column and row with it",
            where_point(lambda x, y: 0 <= x < 20 and 0 <= y < 20),
            1,
        ),
        (
            "the point was pushed back to the edge: beyond the mat there is no cell, so give None",
            lambda x, y: index_on_mat(min(max(x, 0), 199.9), min(max(y, 0), 199.9)),
            1,
        ),
        (
            "beyond the mat the answer is None, not -1: -1 is the last place in a Python list",
            lambda x, y: index_on_mat(x, y, else_=-1),
            1,
        ),
        (
            "beyond the mat the answer is None, not False",
            lambda x, y: index_on_mat(x, y, else_=False),
            1,
        ),
        mistake(
            "index 0 gave None: in Python 0 counts as False, so compare with None or with the "
            "edges, not with `or`",
            lambda x, y: index_on_mat(x, y) or None,
            1,
            where=code("_ or None"),
        ),
        (
            "index 0 gave None: it is the cell of column 0 and row 0, and on the mat like others",
            lambda x, y: index_on_mat(x, y) or None,
            1,
        ),
        (
            "the list was asked, and not the mat: it has an index -1, and right of the mat it goes "
            "on with the next row; check column and row one by one",
            where_cell(lambda column, row: -400 <= row * 20 + column < 400),
            1,
        ),
        (
            "the list was asked, and not the mat: column and row must be below ACROSS, and not "
            "below 0",
            where_cell(lambda column, row: -20 <= column < 20 and -20 <= row < 20),
            1,
        ),
        *(
            mistake(
                "int() cuts -0.4 off to 0, so points just left of the mat or below it got a cell: "
                "use cell_of(), or math.floor()",
                by_parts(cut),
                1,
                where=calls("int"),
            )
            for cut in (lambda x: int(x / 10), lambda x: int(x) // 10)
        ),
        mistake(
            "range() holds whole numbers only, and x and y need not be whole: ask whether column "
            "and row are in range(ACROSS)",
            where_point(lambda x, y: x in range(200) and y in range(200)),
            1,
            where=calls("range"),
        ),
        mistake(
            "`and` binds more tightly than `or`: a point is beyond the mat if any one of the four "
            "holds, so join all four with or",
            where_cell(
                lambda column, row: not (column < 0 or (column >= 20 and row < 0) or row >= 20)
            ),
            1,
            where=(operator("and"), operator("or")),
        ),
        mistake(
            "`and` asks that both hold: a point is beyond the mat if its column or its row is, so "
            "join the four with or",
            where_cell(lambda column, row: max(column, row) >= 0 and min(column, row) < 20),
            1,
            where=operator("and"),
        ),
        mistake(
            "a half goes to the even number with round(), so points on a line between two cells "
            "get the wrong one: use cell_of(), or math.floor()",
            by_parts(lambda x: round(x / 10 - 0.5)),
            0,
            where=calls("round"),
        ),
        mistake(
            "a row holds ACROSS cells: multiply the row by ACROSS, not by CELL",
            changed(lambda column, row: row * 10 + column),
            0,
            where=reads("CELL"),
        ),
        (
            "one too many: the first cell of the list has index 0",
            changed(lambda column, row: row * 20 + column + 1),
            0,
        ),
        (
            "rows were counted from the top: the list begins with the bottom row",
            changed(lambda column, row: (19 - row) * 20 + column),
            0,
        ),
        (
            "row and column were only added: skip complete rows of ACROSS cells first",
            changed(lambda column, row: row + column),
            0,
        ),
    ],
)

TYPED_IN = "20 is typed in as the number of cells across: use ACROSS, so that it can change"


def with_20_for(columns, rows, across):
    """What a mistake answers that has these numbers of cells, with 25 cm each."""
    return lambda x, y: index_on_mat(
        x,
        y,
        lambda column, row: 0 <= column < columns and 0 <= row < rows,
        side=25,
        across=across,
    )


CELLS_OF_25 = function(
    "index_of(x, y)",
    lambda x, y: index_on_mat(x, y, side=25, across=8),
    mistakes=[
        mistake(TYPED_IN, with_20_for(*numbers), 1, where=number(20))
        for numbers in ((20, 20, 20), (8, 8, 20), (20, 20, 8), (20, 8, 8), (8, 20, 8))
    ],
)


@check("Points on the mat", hint=0)
def on_the_mat(task):
    task.call(index_of, 35, 75, gives=143)
    task.call(index_of, 105, 5, gives=10)


@check("Points on a line between two cells", hint=0)
def between_cells(task):
    task.call(index_of, 10, 10, gives=21)
    task.call(index_of, 30, 50, gives=103)
    task.call(index_of, 25, 120, gives=242)


@check("The cells at the edges and in the corners", hint=1)
def edges(task):
    task.call(index_of, 0, 0, gives=0)
    task.call(index_of, 3, 64, gives=120)
    task.call(index_of, 0, 45, gives=80)
    task.call(index_of, 35, 0, gives=3)
    task.call(index_of, 195, 5, gives=19)
    task.call(index_of, 5, 15, gives=20)
    task.call(index_of, 199.9, 199.9, gives=399)
    task.call(index_of, 199.99, 55, gives=119)
    task.call(index_of, 55, 199.99, gives=385)


@check("Points right of the mat and above it", hint=1)
def far_edges(task):
    task.call(index_of, 207, 44, gives=None)
    task.call(index_of, 60, 204, gives=None)
    task.call(index_of, 200, 100, gives=None)
    task.call(index_of, 100, 200, gives=None)
    task.call(index_of, 200, 0, gives=None)
    task.call(index_of, 207, 204, gives=None)


@check("Points left of the mat and below it", hint=1)
def near_edges(task):
    task.call(index_of, -4, 150, gives=None)
    task.call(index_of, 150, -0.1, gives=None)
    task.call(index_of, -0.1, 0, gives=None)
    task.call(index_of, -4, 207, gives=None)
    task.call(index_of, 207, -4, gives=None)


@check("Many points, on the mat and round it", hint=2)
def many(task):
    for _ in range(40):
        x, y = (round(task.random.uniform(-30, 230), 1) for _ in range(2))
        task.call(index_of, x, y)


@check("Cells of 25 cm, 8 across", hint=2)
def another_size(task):
    task.set("CELL", 25)
    task.set("ACROSS", 8)
    task.call(CELLS_OF_25, 110, 60, gives=20)
    task.call(CELLS_OF_25, 199.9, 199.9, gives=63)
    task.call(CELLS_OF_25, 201, 10, gives=None)
    task.call(CELLS_OF_25, 10, 201, gives=None)
    task.call(CELLS_OF_25, 10, -1, gives=None)
