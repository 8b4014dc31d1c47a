"""cells_passed(x, y, angle, reading) with NumPy: the cells that a beam passed.

The robot faces 20 degrees meanwhile, so that a heading which is added to the angle shows.
"""

from math import ceil, degrees, floor

from grader import calls, check, code, function, mistake, number, operator
from mapping.beam import end_of_beam

CELL, ACROSS = 5, 40


def passed(
    x,
    y,
    angle,
    reading,
    step=None,
    short=None,
    first=0,
    to_whole=floor,
    keep=None,
    cell=5,
    count=ceil,
):
    """The cells at each step up to `short` cm before the hit that `keep(column, row)` keeps.

    count  how many steps there are in a quotient
    step, short, keep  half a cell, a cell, and whether it is on the mat, unless they are given
    """
    step = cell / 2 if step is None else step
    steps = max(0, count((reading - (cell if short is None else short)) / step))
    points = [end_of_beam(x, y, angle, i * step) for i in range(first, steps)]
    cells = [(to_whole(px / cell), to_whole(py / cell)) for px, py in points]
    if keep is None:
        return [(c, r) for c, r in cells if 0 <= c < 200 / cell and 0 <= r < 200 / cell]
    return [each for each in cells if keep(*each)]


def key(cell):
    """A cell with the kind of its numbers: a float is no index."""
    return tuple((type(part), part) for part in cell) if isinstance(cell, list | tuple) else cell


def same_cells(expected, got):
    """The same cells, in any order; one may well be named more than once."""
    try:
        return {key(cell) for cell in expected} == {key(cell) for cell in got}
    except TypeError:
        return False


def beam(random):
    """A slanting beam, from near the middle of the mat."""
    x, y = (round(random.uniform(90, 110), 1) for _ in range(2))
    return x, y, round(random.uniform(0, 360), 1), round(random.uniform(30, 90), 1)


def with_other(**otherwise):
    """What a mistake answers that walks otherwise."""
    return lambda *asked: passed(*asked, **otherwise)


def along(direction):
    """What a mistake answers that walks in another direction."""
    return lambda x, y, angle, reading: passed(x, y, direction(angle), reading)


def everything(column, row):
    return True


cells_passed = function(
    "cells_passed(x, y, angle, reading)",
    passed,
    compare=same_cells,
    cell_cm=CELL,
    mistakes=[
        (
            "steps of a whole cell jump over corners: step half a cell, CELL / 2",
            with_other(step=CELL),
            0,
        ),
        mistake(
            "a step is CELL / 2, which is 2.5 cm: CELL // 2 is only 2",
            with_other(step=CELL // 2),
            0,
            where=operator("//"),
        ),
        (
            "the last step is missing: every step that is less than reading - CELL counts, so "
            "round their number up",
            with_other(count=floor),
            0,
        ),
        (
            "one step too far: a step at exactly reading - CELL does not count, only those that "
            "are less",
            with_other(count=lambda steps: floor(steps) + 1),
            0,
        ),
        (
            "walked too far, right up to the hit: stop one cell short of it, at reading - CELL",
            with_other(short=0),
            0,
        ),
        (
            "the step at 0 cm is missing: the walk begins where the beam begins",
            with_other(first=1),
            0,
        ),
        (
            "the beam went straight up: its angle decides the direction",
            along(lambda angle: 0),
            1,
        ),
        mistake(
            "90 - angle goes with cosine for x and sine for y: leave one of the two changes out",
            along(lambda angle: 90 - angle),
            1,
            where=code("90 - angle"),
        ),
        mistake(
            "sine and cosine are the wrong way round: x goes by sine, y by cosine",
            along(lambda angle: 90 - angle),
            1,
            where=(calls("sin"), calls("cos")),
        ),
        (
            "the beam goes backwards: look at the signs of x and y, and at what is added to the "
            "angle",
            along(lambda angle: angle + 180),
            1,
        ),
        mistake(
            "heading() was added: the angle is the direction on the mat already",
            along(lambda angle: angle + 20),
            1,
            where=calls("heading"),
        ),
        mistake(
            "degrees were taken for radians: np.radians() makes radians of them",
            along(degrees),
            1,
            where=calls("sin", "cos", "exp", "rect"),
        ),
        (
            "cells beyond the mat were kept: choose the rows whose column and row are both from 0 "
            "to ACROSS - 1",
            with_other(keep=everything),
            2,
        ),
        (
            "a column or row of 40 got through: counted from 0, the last one is ACROSS - 1",
            with_other(keep=lambda c, r: 0 <= c <= ACROSS and 0 <= r <= ACROSS),
            2,
        ),
        (
            "column 0 and row 0 are on the mat: 0 must pass the check",
            with_other(keep=lambda c, r: 0 < c < ACROSS and 0 < r < ACROSS),
            2,
        ),
        mistake(
            "a cell was kept if its column or its row is good: both must be, so np.all, not np.any",
            with_other(keep=lambda c, r: 0 <= c < ACROSS or 0 <= r < ACROSS),
            2,
            where=calls("any"),
        ),
        (
            "a cell was kept if its column or its row is good: both must be",
            with_other(keep=lambda c, r: 0 <= c < ACROSS or 0 <= r < ACROSS),
            2,
        ),
        (
            "a cell was kept if its column is good: the row must be good as well",
            with_other(keep=lambda c, r: 0 <= c < ACROSS),
            2,
        ),
        (
            "cells beyond the mat were pushed back to its edge: leave them out instead",
            lambda *asked: [
                (min(max(c, 0), ACROSS - 1), min(max(r, 0), ACROSS - 1))
                for c, r in passed(*asked, keep=everything)
            ],
            2,
        ),
        mistake(
            "astype(int) cuts towards 0, so a little left of the mat becomes column 0; use "
            "np.floor() first",
            with_other(to_whole=int),
            2,
            where=calls("astype"),
        ),
        (
            "rounded to the nearest whole number: a point in the upper half of a cell then gets "
            "the next cell; use np.floor()",
            with_other(to_whole=round),
            2,
        ),
        (
            "the numbers are right, but they are floats, which can't be an index: .astype(int) "
            "makes whole numbers of them",
            lambda *asked: [(float(c), float(r)) for c, r in passed(*asked)],
            2,
        ),
        (
            "column and row are the wrong way round: each row of the answer is (column, row)",
            lambda *asked: [(row, column) for column, row in passed(*asked)],
            1,
        ),
    ],
)

CELLS_OF_10 = function(
    "cells_passed(x, y, angle, reading)",
    with_other(cell=10),
    compare=same_cells,
    cell_cm=10,
    mistakes=[
        mistake(
            "2.5 is typed in as the step: use CELL / 2, so that CELL can change",
            with_other(step=2.5, cell=10),
            0,
            where=number(2.5),
        ),
        mistake(
            "40 is typed in as the number of cells across: use ACROSS, so that it can change",
            with_other(keep=lambda c, r: 0 <= c < 40 and 0 <= r < 40, cell=10),
            2,
            where=number(40),
        ),
    ],
)


def ask(task, *asked, **gives):
    task.call(cells_passed, *asked, **gives, world="wall-askew")


@check("A beam straight up the mat", hint=0)
def up(task):
    gives = [(20, row) for row in range(8, 17) for _ in range(2)][:-1]
    ask(task, 102.5, 42.5, 0, 46.5, gives=gives)
    ask(task, 102.5, 42.5, 0, 48)
    ask(task, 102.5, 41, 0, 45)
    ask(task, 102.5, 41, 0, 45.3)


@check("Slanting beams", hint=1)
def slanting(task):
    for _ in range(12):
        ask(task, *beam(task.random))


@check("Something very close", hint=0)
def close(task):
    ask(task, 102.5, 42.5, 0, 4, gives=[])


@check("A beam that leaves the mat", hint=2)
def beyond(task):
    ask(task, 172.5, 182.5, 40, 60.7)
    ask(task, 2.5, 52.5, 200, 50.3)
    ask(task, 22.5, 7.5, 170, 40.3)


@check("Cells of 10 cm, 20 across", hint=2)
def another_size(task):
    task.set("CELL", 10)
    task.set("ACROSS", 20)
    task.call(CELLS_OF_10, 105, 45, 29, 83, world="wall-askew")
    task.call(CELLS_OF_10, 175, 185, 40, 60.7, world="wall-askew")


@check("Without a loop", hint=0)
def without_a_loop(task):
    task.no_loop(cells_passed, "NumPy works on all the steps at once")
