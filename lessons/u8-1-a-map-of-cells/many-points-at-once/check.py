"""cells_of(points): the cells of those points that lie on the mat, with NumPy."""

from math import floor

from grader import calls, check, function, mistake, number


def cells(points, to_whole=floor, keep=None, side=10, across=20):
    """The cells of the points that `keep(column, row)` keeps; without it, of those on the mat."""
    found = [(to_whole(x / side), to_whole(y / side)) for x, y in points]
    if keep is None:
        return [(c, r) for c, r in found if 0 <= c < across and 0 <= r < across]
    return [cell for cell in found if keep(*cell)]


def everything(column, row):
    return True


def kept(keep):
    """What a mistake answers that keeps other cells."""
    return lambda points: cells(points, keep=keep)


TYPED_IN = "10 or 20 is typed in: use CELL and ACROSS, so that they can change"

cells_of = function(
    "cells_of(points)",
    cells,
    mistakes=[
        (
            "the cells of points beyond the mat were kept: choose the rows whose column and row "
            "are both from 0 to ACROSS - 1",
            kept(everything),
            1,
        ),
        mistake(
            "astype(int) cuts towards 0, so a little left of the mat becomes column 0; use "
            "np.floor() first",
            lambda points: cells(points, to_whole=int),
            0,
            where=calls("astype"),
        ),
        (
            "rounded to the nearest whole number: a point in the upper half of a cell then gets "
            "the next cell; use np.floor()",
            lambda points: cells(points, to_whole=round),
            0,
        ),
        (
            "the numbers are right, but they are floats: .astype(int) makes whole numbers of them",
            lambda points: [(float(c), float(r)) for c, r in cells(points)],
            0,
        ),
        mistake(
            "a point was kept if its column or its row is good: both must be, so np.all, not "
            "np.any",
            kept(lambda c, r: 0 <= c < 20 or 0 <= r < 20),
            2,
            where=calls("any"),
        ),
        (
            "a point was kept if its column or its row is good: both must be",
            kept(lambda c, r: 0 <= c < 20 or 0 <= r < 20),
            2,
        ),
        (
            "column and row are the wrong way round: the points come as (x, y), so the column is "
            "first already",
            lambda points: [(row, column) for column, row in cells(points)],
            0,
        ),
        (
            "a column or row of 20 got through: counted from 0, the last column is ACROSS - 1",
            kept(lambda c, r: 0 <= c <= 20 and 0 <= r <= 20),
            1,
        ),
        (
            "column 0 and row 0 are on the mat: 0 must pass the check",
            kept(lambda c, r: 0 < c < 20 and 0 < r < 20),
            1,
        ),
        (
            "points right of the mat and above it were kept: a column or row must be below ACROSS "
            "as well",
            kept(lambda c, r: c >= 0 and r >= 0),
            1,
        ),
        (
            "points left of the mat and below it were kept: a column or row must be 0 or more as "
            "well",
            kept(lambda c, r: c < 20 and r < 20),
            1,
        ),
        (
            "only the column was checked: above and below the mat there are no cells either",
            kept(lambda c, r: 0 <= c < 20),
            1,
        ),
        (
            "points beyond the mat were pushed back to its edge: leave them out instead",
            lambda points: [
                (min(max(c, 0), 19), min(max(r, 0), 19)) for c, r in cells(points, keep=everything)
            ],
            1,
        ),
        (
            "each cell came out only once, and sorted: a point of the list gets its own row, in "
            "the list's order",
            lambda points: sorted(set(cells(points))),
            1,
        ),
        (
            "those are the points themselves: divide them by CELL and round down",
            lambda points: [
                (float(x), float(y)) for x, y in points if 0 <= min(x, y) <= max(x, y) < 200
            ],
            0,
        ),
        (
            "those are the answers to the comparison: use them to choose rows, cells[on_the_mat]",
            lambda points: [0 <= x < 200 and 0 <= y < 200 for x, y in points],
            2,
        ),
        (
            "one long row of numbers came out: ask of each row of cells whether all of it is "
            "good, with axis=1",
            lambda points: [
                number
                for cell in cells(points, keep=everything)
                for number in cell
                if 0 <= number < 20
            ],
            2,
        ),
    ],
)

CELLS_OF_25 = function(
    "cells_of(points)",
    lambda points: cells(points, side=25, across=8),
    mistakes=[
        mistake(
            TYPED_IN,
            cells,
            1,
            where=number(10, 20),
        ),
        mistake(
            TYPED_IN,
            lambda points: cells(points, side=10, across=8),
            1,
            where=number(10, 20),
        ),
        mistake(
            TYPED_IN,
            lambda points: cells(points, side=25, across=20),
            1,
            where=number(10, 20),
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
    task.call(cells_of, [[207, 44], [100, 200]], gives=[])


@check("Two points in one cell", hint=1)
def twice(task):
    task.call(cells_of, [[58, 12], [51, 19], [3, 88]], gives=[(5, 1), (5, 1), (0, 8)])


@check("Many points", hint=2)
def many(task):
    task.call(
        cells_of,
        [[round(task.random.uniform(-30, 230), 1) for _ in range(2)] for _ in range(60)],
    )


@check("Cells of 25 cm, 8 across", hint=2)
def another_size(task):
    task.set("CELL", 25)
    task.set("ACROSS", 8)
    task.call(
        CELLS_OF_25,
        [[32, 74], [199, 199], [210, 30], [30, 230]],
        gives=[(1, 2), (7, 7)],
    )


@check("Without a loop", hint=0)
def without_a_loop(task):
    task.no_loop(cells_of, "NumPy works on all the points at once")
