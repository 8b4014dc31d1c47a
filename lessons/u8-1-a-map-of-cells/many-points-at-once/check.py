"""cells_of(points): the cells of those points that lie on the mat, with NumPy."""

from math import floor

from grader import check, function


def cells(points, to_whole=floor, keep=lambda column, row: 0 <= column < 20 and 0 <= row < 20):
    found = [(to_whole(x / 10), to_whole(y / 10)) for x, y in points]
    return [each for each in found if keep(*each)]


cells_of = function(
    "cells_of(points)",
    cells,
    mistakes=[
        (
            "the cells of points beyond the mat were kept: choose the rows whose column and row "
            "are both from 0 to ACROSS - 1",
            lambda points: cells(points, keep=lambda column, row: True),
            1,
        ),
        (
            "astype(int) cuts towards 0, so a little left of the mat looks like column 0; use "
            "np.floor() first",
            lambda points: cells(points, to_whole=int),
            0,
        ),
        (
            "np.any keeps a point if its column or its row is good: both must be, so np.all",
            lambda points: cells(points, keep=lambda c, r: 0 <= c < 20 or 0 <= r < 20),
            2,
        ),
        (
            "column and row look swapped: the points come as (x, y), so the column is already "
            "first",
            lambda points: [(row, column) for column, row in cells(points)],
            0,
        ),
        (
            "a column or row of 20 got through: counted from 0, the last column is ACROSS - 1",
            lambda points: cells(points, keep=lambda c, r: 0 <= c <= 20 and 0 <= r <= 20),
            1,
        ),
        (
            "one long row of numbers came out: ask for each row of cells whether all of it is "
            "good, with axis=1",
            lambda points: [
                each
                for pair in cells(points, keep=lambda c, r: True)
                for each in pair
                if 0 <= each < 20
            ],
            2,
        ),
    ],
)


@check("Points on the mat", hint=0)
def on_the_mat(task):
    task.call(cells_of, [[32, 74], [151.5, 23], [0, 0]], gives=[(3, 7), (15, 2), (0, 0)])


@check("Points at the edge and beyond", hint=1)
def edge(task):
    task.call(
        cells_of,
        [[199.9, 5], [200, 5], [50, 207], [-3, 50], [50, -0.1], [-5, -5], [7, 9]],
        gives=[(19, 0), (0, 0)],
    )


@check("Many points", hint=2)
def many(task):
    task.call(
        cells_of,
        [[round(task.random.uniform(-30, 230), 1) for _ in range(2)] for _ in range(60)],
    )
