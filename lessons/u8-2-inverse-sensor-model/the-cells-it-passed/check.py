"""cells_passed(x, y, angle, reading): the cells of 5 cm that a beam passed."""

from math import ceil, degrees

from bugbot.frames import cell_of
from grader import check, function
from mapping.beam import end_of_beam

CELL = 5


def passed(x, y, angle, reading, step=CELL / 2, first=0, short=CELL):
    """The cells at each step, from the step `first`, nearer than `short` cm before the hit."""
    steps = range(first, max(0, ceil((reading - short) / step)))
    cells = [cell_of(*end_of_beam(x, y, angle, i * step), CELL) for i in steps]
    return [cell for cell in cells if cell is not None]


def same_cells(expected, got):
    """The same cells, in any order; one may well be named more than once."""
    try:
        right, answer = ({cell and tuple(cell) for cell in cells} for cells in (expected, got))
        return right == answer
    except TypeError:
        return False


def with_none(x, y, angle, reading):
    steps = range(ceil((reading - CELL) / (CELL / 2)))
    return [cell_of(*end_of_beam(x, y, angle, i * CELL / 2), CELL) for i in steps]


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
            "only one cell of the beam came out: walk along it, and append the cell at each step",
            lambda x, y, angle, reading: [cell_of(*end_of_beam(x, y, angle, reading - CELL), CELL)],
            0,
        ),
        (
            "steps of a whole cell jump over corners: step half a cell, CELL / 2",
            lambda x, y, angle, reading: passed(x, y, angle, reading, step=CELL),
            1,
        ),
        (
            "walked too far, right up to the hit: stop one cell short of it, at reading - CELL",
            lambda x, y, angle, reading: passed(x, y, angle, reading, short=0),
            1,
        ),
        (
            "the cell where the beam begins is missing: the first step is at 0 cm",
            lambda x, y, angle, reading: passed(x, y, angle, reading, first=1),
            2,
        ),
        (
            "sine and cosine look swapped: end_of_beam has them right, so call it",
            lambda x, y, angle, reading: passed(x, y, 90 - angle, reading),
            0,
        ),
        (
            "degrees look taken for radians: end_of_beam takes degrees, so call it",
            lambda x, y, angle, reading: passed(x, y, degrees(angle), reading),
            0,
        ),
        (
            "None is not a cell: where cell_of gives None, append nothing",
            with_none,
            2,
        ),
        (
            "steps of 1 cm find cells that the beam hardly touches: step half a cell, CELL / 2",
            lambda x, y, angle, reading: passed(x, y, angle, reading, step=1),
            1,
        ),
    ],
)


@check("A beam straight up the mat", hint=0)
def up(task):
    gives = [(20, row) for row in range(8, 17)]
    task.call(cells_passed, 102.5, 42.5, 0, 46.5, gives=gives)


@check("A beam to the right", hint=0)
def to_the_right(task):
    gives = [(column, 2) for column in range(10, 16)]
    task.call(cells_passed, 52.5, 12.5, 90, 31.5, gives=gives)


@check("Slanting beams", hint=1)
def slanting(task):
    for _ in range(12):
        task.call(cells_passed, *beam(task.random))


@check("Something very close", hint=2)
def close(task):
    task.call(cells_passed, 102.5, 42.5, 0, 4, gives=[])


@check("A beam that leaves the mat, as noise or a wrong pose may have it", hint=2)
def beyond(task):
    task.call(cells_passed, 172.5, 182.5, 40, 60.7)
    task.call(cells_passed, 2.5, 52.5, 200, 50.3)
