"""beam_says(x, y, angle, reading): free cells, and the cell hit; FAR or more is no hit.

Every reading is such that it makes no difference whether a last, shorter step is taken.
"""

from bugbot.frames import cell_of
from grader import calls, check, exactly, function, in_words, mistake, number
from mapping.beam import end_of_beam

CELL, FAR = 5, 170


def walked(x, y, angle, length, cell=CELL):
    steps = range(max(0, int(length / (cell / 2))))
    cells = [cell_of(*end_of_beam(x, y, angle, i * cell / 2), cell) for i in steps]
    return [cell for cell in cells if cell is not None]


def says(
    x, y, angle, reading, wall=None, free=FAR, hit=None, far=FAR, short=CELL, back=0, cell=CELL
):
    """(free cells, hit): `free` cm and a hit at `hit` cm for a reading that is no wall."""
    is_wall = reading < far if wall is None else wall(reading)
    length, end = (reading - short, reading - back) if is_wall else (free, hit)
    there = None if end is None else cell_of(*end_of_beam(x, y, angle, end), cell)
    return walked(x, y, angle, length, cell), there


def key(cell):
    return tuple(cell) if isinstance(cell, list | tuple) else cell


def same(expected, got):
    """The same free cells, in any order and however often, and the same hit."""
    if exactly(expected, got):  # what a mistake answers may be no pair of cells and hit
        return True
    try:
        (right_free, right_hit), (free, hit) = expected, got
        same_free = {key(cell) for cell in free} == {key(cell) for cell in right_free}
        return same_free and (hit is None) == (right_hit is None) and key(hit) == key(right_hit)
    except (TypeError, ValueError):
        return False


def named(cells):
    """Some cells in words, the first few of many."""
    shown = ", ".join(str(cell) for cell in sorted(cells)[:4])
    more = f" and {len(cells) - 4} more" if len(cells) > 4 else ""
    return shown + more


def apart(expected, got):
    """What is wrong with the free cells or with the hit, in words."""
    try:
        (right_free, right_hit), (free, hit) = expected, got
        wanted, there = {key(cell) for cell in right_free}, {key(cell) for cell in free}
        missing, extra = wanted - there, there - wanted
        if missing:
            return f"{named(missing)} among the free cells", "missing there"
        if extra:
            return f"{len(wanted)} free cells", f"also {named(extra)}, which should not be there"
    except (TypeError, ValueError):
        return None
    return f"{right_hit} as the hit", f"{hit}"


def otherwise(**changed):
    """What a mistake answers that takes a reading otherwise."""
    return lambda *asked: says(*asked, **changed)


def hit_instead(nothing):
    """What a mistake answers that has something else for None."""

    def answer(*asked):
        free, hit = says(*asked)
        return free, nothing if asked[-1] >= FAR else hit

    return answer


def with_hit_free(added):
    """What a mistake answers that counts the cell hit among the free ones as well."""

    def answer(*asked):
        free, hit = says(*asked)
        return ([*free, hit] if added(hit, asked[-1]) else free), hit

    return answer


NO_CELL = "where nothing was found, hit is None: the program asks for just that"

beam_says = function(
    "beam_says(x, y, angle, reading)",
    says,
    compare=in_words(same, apart),
    mistakes=[
        (
            "the maximum was taken for a wall: a reading of FAR or more means that nothing was "
            "found, so hit is None",
            otherwise(wall=lambda reading: True),
            0,
        ),
        (
            "only the maximum of 200 counts as nothing: from FAR on a reading is no wall",
            otherwise(wall=lambda reading: reading < 200),
            0,
        ),
        (
            "a reading of nothing is evidence too: the floor is free as far as FAR",
            otherwise(free=0),
            1,
        ),
        (
            "free further than FAR: a long reading is believed only as far as FAR",
            lambda x, y, angle, reading: says(x, y, angle, reading, free=reading),
            1,
        ),
        (
            "free further than FAR: a long reading is believed only as far as FAR",
            lambda x, y, angle, reading: says(x, y, angle, reading, free=reading - CELL),
            1,
        ),
        (
            "free further than FAR: a long reading is believed only as far as FAR",
            otherwise(free=200),
            1,
        ),
        (
            "a hit at FAR: where nothing was found, no cell was hit, so hit is None",
            otherwise(hit=FAR),
            0,
        ),
        (
            "a long reading was cut to FAR and then taken for a wall there: nothing was found, so "
            "hit is None and the floor is free right up to FAR",
            otherwise(free=FAR - CELL, hit=FAR),
            0,
        ),
        (
            "one cell too few: there is no hit to stop short of, so the floor is free right up to "
            "FAR",
            otherwise(free=FAR - CELL),
            1,
        ),
        (
            "a reading of exactly FAR was taken for a wall: FAR or more is no hit",
            otherwise(wall=lambda reading: reading <= FAR),
            2,
        ),
        (
            "the two cases are the wrong way round: a reading below FAR is a wall, FAR or more is "
            "no hit",
            otherwise(wall=lambda reading: reading >= FAR),
            0,
        ),
        (
            "free right up to the hit: for a wall the floor is free only up to reading - CELL",
            otherwise(short=0),
            2,
        ),
        (
            "the hit is one cell too near: the beam ended at the full reading",
            otherwise(back=CELL),
            2,
        ),
        (
            "the hit comes first here: the answer is the free cells, then the hit",
            lambda *asked: says(*asked)[::-1],
            2,
        ),
        (
            "a hit that lies beyond the mat is a wall all the same: the floor is free up to "
            "reading - CELL, not further",
            lambda x, y, angle, reading: says(
                x,
                y,
                angle,
                reading,
                short=CELL if says(x, y, angle, reading)[1] else reading - FAR,
            ),
            2,
        ),
        *(
            ("the cell that was hit is not free: it is no part of the list", slip, 2)
            for slip in (
                with_hit_free(lambda hit, reading: hit is not None),
                with_hit_free(lambda hit, reading: reading < FAR),
                with_hit_free(lambda hit, reading: True),
            )
        ),
        *(
            mistake(
                "the reading was rounded: take it as it is",
                lambda x, y, angle, reading, rounded=rounded: says(x, y, angle, rounded(reading)),
                2,
                where=calls("int", "round", "floor"),
            )
            for rounded in (int, round)
        ),
        (NO_CELL, hit_instead([]), 1),
        (NO_CELL, hit_instead(False), 1),
        (NO_CELL, hit_instead((None, None)), 1),
        (NO_CELL, hit_instead(-1), 1),
        (NO_CELL, hit_instead(0), 1),
    ],
)

FAR_TYPED_IN = "170 is typed in: use FAR, so that it can change"
CELL_TYPED_IN = "5 is typed in as the side of a cell: use CELL, so that it can change"

OF_OTHER_SIZE = function(
    "beam_says(x, y, angle, reading)",
    otherwise(cell=10, short=10, far=120, free=120),
    compare=in_words(same, apart),
    mistakes=[
        mistake(
            FAR_TYPED_IN,
            otherwise(cell=10, short=10),
            2,
            where=number(170),
        ),
        mistake(
            FAR_TYPED_IN,
            otherwise(cell=10, short=10, far=120),
            2,
            where=number(170),
        ),
        mistake(
            FAR_TYPED_IN,
            otherwise(cell=10, short=10, free=120),
            2,
            where=number(170),
        ),
        mistake(
            CELL_TYPED_IN,
            otherwise(cell=10, short=5, far=120, free=120),
            2,
            where=number(5),
        ),
    ],
)


@check("A wall at 50 cm", hint=2)
def wall(task):
    task.call(beam_says, 22.5, 32.5, 90, 50)
    task.call(beam_says, 22.8, 32.5, 90, 62.5)


@check("Nothing found: 200 cm", hint=0)
def nothing(task):
    task.call(beam_says, 12.5, 12.5, 45, 200)
    task.call(beam_says, 12.5, 12.5, 0, 200)


@check("Readings from 170 to 200", hint=0)
def far(task):
    for reading in (170, 178.3, 199.9):
        task.call(beam_says, 12.5, 12.5, 57, reading)


@check("A reading just under 170", hint=2)
def just_under(task):
    task.call(beam_says, 22.5, 12.5, 30, 169.9)


@check("A hit that noise has put beyond the mat", hint=2)
def beyond(task):
    task.call(beam_says, 132.5, 92.5, 90, 70)
    task.call(beam_says, 132.5, 92.5, 90, 67.5)


@check("A hit in the corner of the mat", hint=2)
def corner(task):
    task.call(beam_says, 2.5, 52.5, 180, 50)


@check("With FAR at 120 cm, and cells of 10 cm", hint=2)
def another_far(task):
    for name, value in {"FAR": 120, "CELL": 10, "ACROSS": 20}.items():
        task.set(name, value)
    task.call(OF_OTHER_SIZE, 25, 15, 30, 110)
    task.call(OF_OTHER_SIZE, 25, 15, 30, 140)
