"""index_of(x, y): the place in the list of a point's cell, None beyond the mat."""

from math import floor

from grader import check, function


def index_on_mat(x, y, holds=lambda column, row: 0 <= column < 20 and 0 <= row < 20):
    column, row = floor(x / 10), floor(y / 10)
    return row * 20 + column if holds(column, row) else None


def column_by_column(x, y):
    index = index_on_mat(x, y)
    return None if index is None else index % 20 * 20 + index // 20


index_of = function(
    "index_of(x, y)",
    index_on_mat,
    mistakes=[
        (
            "column and row look swapped: the list goes row after row, so row * ACROSS + column",
            column_by_column,
            0,
        ),
        (
            "nothing keeps points beyond the mat out: each must give None",
            lambda x, y: index_on_mat(x, y, lambda column, row: True),
            1,
        ),
        (
            "a negative column or row got through: points left of the mat and below it have no "
            "cell",
            lambda x, y: index_on_mat(x, y, lambda column, row: column < 20 and row < 20),
            1,
        ),
        (
            "a column or row of 20 got through: counted from 0, the last column is ACROSS - 1",
            lambda x, y: index_on_mat(x, y, lambda c, r: 0 <= c <= 20 and 0 <= r <= 20),
            1,
        ),
        (
            "column 0 and row 0 are on the mat: 0 must pass the check",
            lambda x, y: index_on_mat(x, y, lambda c, r: 0 < c < 20 and 0 < r < 20),
            1,
        ),
        (
            "only the place in the list was checked: right of the mat that is the first cell of "
            "the next row; check column and row one by one",
            lambda x, y: index_on_mat(x, y, lambda c, r: 0 <= r * 20 + c < 400),
            1,
        ),
        (
            "the point was pushed back to the edge: beyond the mat there is no cell, so give None",
            lambda x, y: index_on_mat(min(max(x, 0), 199.9), min(max(y, 0), 199.9)),
            1,
        ),
    ],
)


@check("Points on the mat", hint=0)
def on_the_mat(task):
    task.call(index_of, 35, 75, gives=143)
    task.call(index_of, 105, 5, gives=10)


@check("The cells at the edges and in the corners", hint=1)
def edges(task):
    task.call(index_of, 0, 0, gives=0)
    task.call(index_of, 3, 64, gives=120)
    task.call(index_of, 195, 5, gives=19)
    task.call(index_of, 5, 15, gives=20)
    task.call(index_of, 199.9, 199.9, gives=399)


@check("Points right of the mat and above it", hint=1)
def far_edges(task):
    task.call(index_of, 207, 44, gives=None)
    task.call(index_of, 60, 204, gives=None)
    task.call(index_of, 200, 100, gives=None)


@check("Points left of the mat and below it", hint=1)
def near_edges(task):
    task.call(index_of, -4, 150, gives=None)
    task.call(index_of, 150, -0.1, gives=None)


@check("Many points, on the mat and round it", hint=2)
def many(task):
    for _ in range(40):
        x, y = (round(task.random.uniform(-30, 230), 1) for _ in range(2))
        task.call(index_of, x, y)
