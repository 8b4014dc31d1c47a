"""beam_says(x, y, angle, reading): free cells, and the cell hit; 170 cm or more is no hit."""

from bugbot.frames import cell_of
from grader import check, function
from mapping.beam import end_of_beam

CELL, FAR = 5, 170


def along(x, y, angle, length):
    steps = range(int(length / (CELL / 2)))
    cells = [cell_of(*end_of_beam(x, y, angle, i * CELL / 2), CELL) for i in steps]
    return [cell for cell in cells if cell is not None]


def says(x, y, angle, reading, wall=lambda reading: reading < FAR, free=FAR, hit=None):
    """(free cells, hit): `free` cm and a hit at `hit` cm for a reading that is no wall."""
    length, end = (reading - CELL, reading) if wall(reading) else (free, hit)
    there = None if end is None else cell_of(*end_of_beam(x, y, angle, end), CELL)
    return along(x, y, angle, length), there


def same(expected, got):
    """The same free cells, in any order and however often, and the same hit."""
    try:
        (right_free, right_hit), (free, hit) = expected, got
        same_free = {tuple(cell) for cell in free} == {tuple(cell) for cell in right_free}
        return same_free and (hit and tuple(hit)) == (right_hit and tuple(right_hit))
    except (TypeError, ValueError):
        return False


beam_says = function(
    "beam_says(x, y, angle, reading)",
    says,
    compare=same,
    mistakes=[
        (
            "the maximum was taken for a wall: a reading of FAR or more means that nothing was "
            "found, so hit is None",
            lambda x, y, angle, reading: says(x, y, angle, reading, lambda r: True),
            0,
        ),
        (
            "only the maximum of 200 counts as nothing: from FAR on a reading is no wall",
            lambda x, y, angle, reading: says(x, y, angle, reading, lambda r: r < 200),
            0,
        ),
        (
            "a reading of nothing is evidence too: the floor is free as far as FAR",
            lambda x, y, angle, reading: says(x, y, angle, reading, free=0),
            1,
        ),
        (
            "free further than FAR: a long reading is believed only as far as FAR",
            lambda x, y, angle, reading: says(x, y, angle, reading, free=reading),
            1,
        ),
        (
            "a hit at FAR: where nothing was found, no cell was hit, so hit is None",
            lambda x, y, angle, reading: says(x, y, angle, reading, hit=FAR),
            0,
        ),
        (
            "one cell too few: there is no hit to stop short of, so the floor is free right up to "
            "FAR",
            lambda x, y, angle, reading: says(x, y, angle, reading, free=FAR - CELL),
            1,
        ),
        (
            "a reading of exactly FAR was taken for a wall: FAR or more is none",
            lambda x, y, angle, reading: says(x, y, angle, reading, lambda r: r <= FAR),
            2,
        ),
        (
            "the wrong way round: a reading below FAR is a wall, FAR or more is none",
            lambda x, y, angle, reading: says(x, y, angle, reading, lambda r: r >= FAR),
            0,
        ),
    ],
)


@check("A wall at 50 cm", hint=2)
def wall(task):
    task.call(beam_says, 22.5, 32.5, 90, 50)


@check("Nothing found: 200 cm", hint=0)
def nothing(task):
    task.call(beam_says, 12.5, 12.5, 45, 200)
    task.call(beam_says, 12.5, 12.5, 0, 200)


@check("Readings from 170 to 200", hint=0)
def far(task):
    for reading in (170, 178.3, 199.9):
        task.call(beam_says, 12.5, 12.5, 50, reading)


@check("A reading just under 170", hint=2)
def just_under(task):
    task.call(beam_says, 22.5, 12.5, 30, 169.9)


@check("A hit that noise has put beyond the mat", hint=2)
def beyond(task):
    task.call(beam_says, 132.5, 92.5, 90, 68.5)
