"""cells_passed(x, y, angle, reading) with NumPy: the cells of 5 cm that a beam passed."""

from math import ceil, degrees, floor

from grader import check, function
from mapping.beam import end_of_beam

CELL = 5


def passed(x, y, angle, reading, step=CELL / 2, short=CELL, to_whole=floor, everywhere=False):
    """The cells at each step nearer than `short` cm before the hit, on the mat or everywhere."""
    points = [
        end_of_beam(x, y, angle, i * step) for i in range(max(0, ceil((reading - short) / step)))
    ]
    cells = [(to_whole(px / CELL), to_whole(py / CELL)) for px, py in points]
    return [(c, r) for c, r in cells if everywhere or (0 <= c < 40 and 0 <= r < 40)]


def same_cells(expected, got):
    """The same cells, in any order; one may well be named more than once."""
    try:
        return {tuple(cell) for cell in expected} == {tuple(cell) for cell in got}
    except TypeError:
        return False


def beam(random):
    """A slanting beam for which it makes no difference whether a last, shorter step is taken."""
    while True:
        x, y = (round(random.uniform(90, 110), 1) for _ in range(2))
        asked = x, y, round(random.uniform(0, 360), 1), round(random.uniform(30, 90), 1)
        with_one_less = passed(*asked, short=CELL * 1.5)
        if same_cells(with_one_less, passed(*asked, short=CELL - 0.01)):
            return asked


cells_passed = function(
    "cells_passed(x, y, angle, reading)",
    passed,
    compare=same_cells,
    cell_cm=CELL,
    mistakes=[
        (
            "steps of a whole cell jump over corners: step half a cell, CELL / 2",
            lambda x, y, angle, reading: passed(x, y, angle, reading, step=CELL),
            0,
        ),
        (
            "walked too far, right up to the hit: stop one cell short of it, at reading - CELL",
            lambda x, y, angle, reading: passed(x, y, angle, reading, short=0),
            0,
        ),
        (
            "sine and cosine look swapped: x goes by sine, y by cosine",
            lambda x, y, angle, reading: passed(x, y, 90 - angle, reading),
            1,
        ),
        (
            "degrees look taken for radians: np.radians() makes radians of them",
            lambda x, y, angle, reading: passed(x, y, degrees(angle), reading),
            1,
        ),
        (
            "cells beyond the mat were kept: choose the rows whose column and row are both from 0 "
            "to ACROSS - 1",
            lambda x, y, angle, reading: passed(x, y, angle, reading, everywhere=True),
            2,
        ),
        (
            "astype(int) cuts towards 0, so a little left of the mat looks like column 0; use "
            "np.floor() first",
            lambda x, y, angle, reading: passed(x, y, angle, reading, to_whole=int),
            2,
        ),
        (
            "column and row look swapped: each row of the answer is (column, row)",
            lambda x, y, angle, reading: [(r, c) for c, r in passed(x, y, angle, reading)],
            1,
        ),
    ],
)


@check("A beam straight up the mat", hint=0)
def up(task):
    gives = [(20, row) for row in range(8, 17) for _ in range(2)][:-1]
    task.call(cells_passed, 102.5, 42.5, 0, 46.5, gives=gives)


@check("Slanting beams", hint=1)
def slanting(task):
    for _ in range(12):
        task.call(cells_passed, *beam(task.random))


@check("Something very close", hint=0)
def close(task):
    task.call(cells_passed, 102.5, 42.5, 0, 4, gives=[])


@check("A beam that leaves the mat", hint=2)
def beyond(task):
    task.call(cells_passed, 172.5, 182.5, 40, 60.7)
    task.call(cells_passed, 2.5, 52.5, 200, 50.3)
