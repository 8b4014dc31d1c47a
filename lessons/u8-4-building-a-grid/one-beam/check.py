"""add_beam(log_odds, x, y, angle, reading): what one beam says, added to a flat list.

The steps are those of the statement, all that are less than the clear length, so readings
are asked that are no whole number of steps. No point lies on a line between cells.
"""

from math import ceil, cos, floor, radians, sin

from grader import calls, check, code, function, mistake, near, operator
from mapping.beam import Weights, passed_by_steps
from mapping.mapper import Mapper

STEP = 2.5


def while_nearer(x, y, angle, length, cell_cm):
    """The cells at all steps that are less than the length, a last one that is begun too."""
    return passed_by_steps(x, y, angle, ceil(length / STEP) * STEP, cell_cm)


def reference(weights):
    def add_beam(log_odds, x, y, angle, reading):
        mapper = Mapper(5, weights, while_nearer)
        mapper.grid.cells = log_odds
        mapper.add_beam(x, y, angle, reading)

    return add_beam


ANYWHERE = range(-100_000, 100_000)


def within(columns=range(40), rows=range(40), numbers=ANYWHERE, whole=floor):
    """The number of a point's cell, or None where column, row or number is not among these."""

    def cell(x, y):
        column, row = whole(x / 5), whole(y / 5)
        number = row * 40 + column
        return number if column in columns and row in rows and number in numbers else None

    return cell


INSIDE = within()


def clamped(before, weight):
    return max(-8, min(8, before + weight))


def up_to_the_hit(reading):
    return 170 if reading >= 170 else reading - 5


def half_cells(clear):
    return steps(ceil(clear / STEP))


def steps(count):
    return [i * STEP for i in range(count)]


def by(
    read=lambda reading: reading,
    direction=lambda angle: (sin(radians(angle)), cos(radians(angle))),
    clear=up_to_the_hit,
    steps=half_cells,
    hit=lambda reading: reading < 170,
    end=lambda reading: reading,
    cell=INSIDE,
    put=clamped,
    pass_weight=-0.4,
    once=lambda weight: False,
    hit_first=False,
):
    """What a mistake in one of these leaves in the list."""

    def add_beam(log_odds, x, y, angle, reading):
        reading = read(reading)
        dx, dy = direction(angle)
        passes = [(along, pass_weight) for along in steps(clear(reading))]
        hits = [(end(reading), 0.85)] if hit(reading) else []
        seen = set()
        for along, weight in hits + passes if hit_first else passes + hits:
            index = cell(x + along * dx, y + along * dy)
            if index is not None and not (once(weight) and index in seen):
                log_odds[index] = put(log_odds[index], weight)
            seen.add(index)

    return add_beam


def slip(said, hint, where=(), **how):
    return mistake(said, by(**how), hint, where=where)


MAX_IS_NO_WALL = "a reading of FAR or more marks no hit: it found nothing"
ROUNDED = "the reading was rounded: work with it as it came in"
TOO_FAR = (
    "one step too far: a step at exactly the clear length does not count, only those that are "
    "less (< and not <=)"
)
LAST_MISSING = (
    "the last step is missing: every half-cell step that is less than the clear length counts"
)
WHOLE_CELLS = "the steps are a whole cell long and jump over corners: go by half cells"
BEYOND = "a point off the mat got a cell: check that column and row are both from 0 to ACROSS - 1"
SHUT_OUT = "cells at the edge of the mat were left out: column and row go "
WRAPPED = "a point off the mat came out on the other side: "

add_beam = function(
    "add_beam(log_odds, x, y, angle, reading)",
    reference(Weights()),
    changes="log_odds",
    grid_cm=5,
    compare=near(0.0001),
    mistakes=[
        mistake(
            "a copy of the list was changed: change log_odds itself, the list that came in",
            lambda log_odds, x, y, angle, reading: None,
            2,
            where=(
                code(
                    "log_odds = list(log_odds)",
                    "log_odds = log_odds[:]",
                    "log_odds = log_odds.copy()",
                    "log_odds = _ + _",
                ),
                lambda text: not text.returns_a_value,
            ),
        ),
        slip(
            "sine and cosine are the wrong way round: an angle is clockwise from "
            "up the mat, so x goes by sine and y by cosine",
            0,
            (calls("sin"), calls("cos")),
            direction=lambda angle: (cos(radians(angle)), sin(radians(angle))),
        ),
        slip(
            "degrees were taken for radians: math.sin() and math.cos() want math.radians(angle)",
            0,
            calls("sin", "cos", "exp", "rect"),
            direction=lambda angle: (sin(angle), cos(angle)),
        ),
        slip(
            "the angle was counted the other way: clockwise means that x grows with the sine",
            0,
            direction=lambda angle: (sin(radians(-angle)), cos(radians(angle))),
        ),
        slip(
            "row and column are the wrong way round: the cell's number is row * ACROSS + column",
            2,
            cell=lambda x, y: INSIDE(y, x),
        ),
        slip(WHOLE_CELLS, 1, steps=lambda clear: half_cells(clear)[::2]),
        slip(WHOLE_CELLS, 1, steps=lambda clear: steps(2 * int(clear / 5))[::2]),
        slip(
            "the steps go on to the hit itself: stop one cell short of it",
            1,
            clear=lambda reading: min(reading, 170),
        ),
        slip(
            LAST_MISSING + ", so count them with math.ceil(), not int()",
            1,
            code("range(int(_))"),
            steps=lambda clear: steps(int(clear / STEP)),
        ),
        slip(LAST_MISSING, 1, steps=lambda clear: steps(floor(clear / STEP))),
        slip(LAST_MISSING, 1, steps=lambda clear: half_cells(clear)[:-1]),
        slip(
            "the number of steps was rounded: it may only be rounded up, with math.ceil(), so that "
            "all those count that are less than the clear length",
            1,
            code("range(round(_))"),
            steps=lambda clear: steps(round(clear / STEP)),
        ),
        *(
            slip(ROUNDED, 1, calls(call), read=read)
            for call, read in (
                ("round", round),
                ("round", lambda reading: round(reading / STEP) * STEP),
                ("int", int),
            )
        ),
        slip(TOO_FAR, 1, steps=lambda clear: steps(floor(clear / STEP) + 1)),
        slip(TOO_FAR, 1, steps=lambda clear: steps(int(clear / STEP) + 1)),
        slip(
            "the step at 0 cm is missing: the robot stands on floor too, so begin there",
            1,
            steps=lambda clear: half_cells(clear)[1:],
        ),
        slip(
            "the maximum was taken for a wall: a reading of FAR or more marks no hit",
            1,
            clear=lambda reading: reading - 5,
            hit=lambda reading: True,
        ),
        slip(MAX_IS_NO_WALL, 1, hit=lambda reading: True),
        slip(
            MAX_IS_NO_WALL + ", not even at FAR",
            1,
            hit=lambda reading: True,
            end=lambda reading: min(reading, 170),
        ),
        slip(
            "a reading of exactly FAR has found nothing either: a hit is less than FAR",
            1,
            clear=lambda reading: 170 if reading > 170 else reading - 5,
            hit=lambda reading: reading <= 170,
        ),
        slip(
            "a reading below CELL has no floor, but its hit counts: L_OCC in the cell where the "
            "beam ended",
            2,
            hit=lambda reading: 5 < reading < 170,
        ),
        slip(
            "a reading of FAR or more was left out: it says that the floor is free up to FAR",
            1,
            clear=lambda reading: 0 if reading >= 170 else reading - 5,
        ),
        slip(
            "the clear length of a reading of FAR or more is FAR, not the reading",
            1,
            clear=lambda reading: reading if reading >= 170 else reading - 5,
        ),
        slip(
            "the clear length of a reading of FAR or more is FAR, not one cell less",
            1,
            clear=lambda reading: min(reading, 170) - 5,
        ),
        slip(
            "the clear length of a reading of FAR or more is FAR: nothing is taken off it",
            1,
            clear=lambda reading: min(reading - 5, 170),
        ),
        slip(
            "there is no clamp: keep every cell between -L_MAX and L_MAX",
            2,
            put=lambda before, weight: before + weight,
        ),
        slip(
            "only the top is clamped: a cell may not fall below -L_MAX either",
            2,
            put=lambda before, weight: min(8, before + weight),
        ),
        slip(
            "only the bottom is clamped: a cell may not rise above L_MAX either",
            2,
            put=lambda before, weight: max(-8, before + weight),
        ),
        slip(
            "the clamp comes before the adding: add first, then clamp what comes out",
            2,
            put=lambda before, weight: clamped(before, 0) + weight,
        ),
        slip(
            "a cell close to its limit was left as it was: it goes on to L_MAX or -L_MAX, "
            "and stays there",
            2,
            put=lambda before, weight: before + weight if abs(before + weight) <= 8 else before,
        ),
        slip(
            "the evidence took the place of what was there: add it to the cell's log odds",
            2,
            put=lambda before, weight: weight,
        ),
        slip(
            "the hit took the place of what was there: add L_OCC to the cell's log odds",
            2,
            put=lambda before, weight: weight if weight > 0 else clamped(before, weight),
        ),
        slip(
            "L_FREE was subtracted: it is negative already, so add it",
            1,
            operator("-"),
            pass_weight=0.4,
        ),
        *(
            slip(
                "a cell is counted only once per beam: give it L_FREE at every half-cell step",
                1,
                once=once,
            )
            for once in (lambda weight: weight < 0, lambda weight: True)
        ),
        slip(
            "the hit is missing: after the floor, L_OCC in the cell where the beam ended",
            2,
            hit=lambda reading: False,
        ),
        slip(
            "the hit comes before the floor: floor first, as a cell at its limit may get both",
            2,
            hit_first=True,
        ),
        slip("the floor is missing: L_FREE at every half-cell step", 1, pass_weight=0),
        slip(BEYOND, 2, cell=within(ANYWHERE, ANYWHERE)),
        *(
            slip(BEYOND + " (ACROSS itself is one too many)", 2, cell=within(*sides))
            for sides in (
                (range(41), range(41)),
                (range(41), range(40)),
                (range(40), range(41)),
            )
        ),
        slip(
            WRAPPED + "check column and row, not the cell's number",
            2,
            cell=within(ANYWHERE, ANYWHERE, range(1600)),
        ),
        slip(
            "only the column is checked: the row has to be from 0 to ACROSS - 1 too",
            2,
            cell=within(rows=ANYWHERE),
        ),
        slip(
            WRAPPED + "a negative number counts from the end of the list, so check the row too",
            2,
            cell=within(rows=ANYWHERE, numbers=range(-1600, 1600)),
        ),
        slip(
            "only the row is checked: the column has to be from 0 to ACROSS - 1 too",
            2,
            cell=within(columns=ANYWHERE),
        ),
        *(
            slip(SHUT_OUT + said, 2, cell=within(*sides))
            for said, sides in (
                ("up to ACROSS - 1", (range(39), range(39))),
                ("up to ACROSS - 1", (range(39), range(40))),
                ("up to ACROSS - 1", (range(40), range(39))),
                ("down to 0", (range(1, 40), range(1, 40))),
                ("down to 0", (range(1, 40), range(40))),
                ("down to 0", (range(40), range(1, 40))),
            )
        ),
        slip(
            "cell number 0, at the bottom left, was left out: an if on its number takes 0 for no",
            2,
            cell=lambda x, y: INSIDE(x, y) or None,
        ),
        slip(
            "int() cuts -0.4 down to 0, so a point just off the mat gets a cell: use math.floor()",
            2,
            calls("int"),
            cell=within(whole=int),
        ),
    ],
)

OTHER = {"l_occ": 2, "l_free": -1, "l_max": 3, "far_cm": 100}
TYPED_IN = [
    (
        f"{names} typed in as a number: use the name, because the check changes its value",
        reference(Weights(**{key: OTHER[key] for key in changed})),
        2,
    )
    for names, changed in (
        ("L_OCC was", ("l_free", "l_max", "far_cm")),
        ("L_FREE was", ("l_occ", "l_max", "far_cm")),
        ("L_MAX was", ("l_occ", "l_free", "far_cm")),
        ("FAR was", ("l_occ", "l_free", "l_max")),
        ("L_OCC and L_FREE were", ("l_max", "far_cm")),
        ("L_OCC, L_FREE, L_MAX and FAR were", ()),
    )
]
believing = function(
    "add_beam(log_odds, x, y, angle, reading)",
    reference(Weights(**OTHER)),
    changes="log_odds",
    grid_cm=5,
    compare=near(0.0001),
    mistakes=TYPED_IN,
)

EMPTY = [0.0] * 1600


@check("A beam straight up the mat", hint=0)
def up(task):
    for reading in (27.5, 48.1, 46.3):  # clear lengths of 9, 17.24 and 16.52 steps
        task.call(add_beam, EMPTY, 102.5, 41, 0, reading)


@check("Beams all round", hint=0)
def all_round(task):
    for angle in (90, 200, 333, -45):
        task.call(add_beam, EMPTY, 103, 71, angle, 20 + 2.5 * task.random.randrange(16))
        task.call(add_beam, EMPTY, 103, 71, angle, round(task.random.uniform(20, 60), 1))
    task.call(add_beam, EMPTY, 103, 71, 20, 3)


@check("A reading of nothing", hint=1)
def nothing(task):
    task.call(add_beam, EMPTY, 12, 13, 45, 200)
    task.call(add_beam, EMPTY, 12, 13, 44, 171)
    task.call(add_beam, EMPTY, 12, 13, 41, 170)
    task.call(add_beam, EMPTY, 12, 13, 46, 167.5)


@check("A map that has been begun", hint=2)
def begun(task):
    cells = [task.random.choice([-3.0, -0.8, 0.85, 2.0]) for _ in EMPTY]
    task.call(add_beam, cells, 52, 51, 70, 60)


@check("The clamp", hint=2)
def clamp(task):
    task.call(add_beam, [7.9] * 1600, 52, 51, 0, 22.5)
    task.call(add_beam, [-7.9] * 1600, 52, 51, 0, 22.5)
    task.call(add_beam, [7.9] * 1600, 101, 71, 45, 5.4)  # floor and hit in the same cell


@check("Off the mat there are no cells", hint=2)
def edge(task):
    task.call(add_beam, EMPTY, 189, 102, 90, 12.5)
    task.call(add_beam, EMPTY, 8, 102, -90, 10)
    task.call(add_beam, EMPTY, 102, 189, 0, 12.5)
    task.call(add_beam, EMPTY, 102, 8, 180, 10)
    task.call(add_beam, EMPTY, 151, 102, 60, 200)
    # Into the corner at the bottom left, and through it.
    task.call(add_beam, EMPTY, 12, 13, 225, 14.2)
    task.call(add_beam, EMPTY, 12, 13, 225, 60)
    # Up to the last cell, in all four directions.
    task.call(add_beam, EMPTY, 8, 102, -90, 12.5)
    task.call(add_beam, EMPTY, 102, 8, 180, 12.5)
    task.call(add_beam, EMPTY, 192, 102, 90, 12.5)
    task.call(add_beam, EMPTY, 102, 192, 0, 12.5)


@check("Other weights, another FAR", hint=2)
def others(task):
    for name, value in zip(("L_OCC", "L_FREE", "L_MAX", "FAR"), OTHER.values()):
        task.set(name, value)
    for reading in (60, 100, 120):
        task.call(believing, EMPTY, 103, 71, task.random.choice([20, 110, 250]), reading)
    task.call(believing, [2.5] * 1600, 103, 71, 20, 40)
    task.call(believing, [-2.5] * 1600, 103, 71, 20, 40)
