"""add_beam(log_odds, x, y, angle, reading): what one beam says, added to a flat list.

Where a reading is a hit, its clear length is a whole number of steps: a loop with < and
int(clear / step) then agree. No point lies on a line between cells.
"""

from math import cos, floor, radians, sin

from grader import calls, check, code, function, mistake, near, operator
from mapping.beam import Weights, passed_by_steps
from mapping.mapper import Mapper


def reference(weights, cell_cm=5):
    def add_beam(log_odds, x, y, angle, reading):
        mapper = Mapper(cell_cm, weights, passed_by_steps)
        mapper.grid.cells = log_odds
        mapper.add_beam(x, y, angle, reading)

    return add_beam


def inside(x, y):
    column, row = floor(x / 5), floor(y / 5)
    return row * 40 + column if 0 <= column < 40 and 0 <= row < 40 else None


def clamped(before, weight):
    return max(-8, min(8, before + weight))


def up_to_the_hit(reading):
    return 170 if reading >= 170 else reading - 5


def half_cells(clear):
    return [i * 2.5 for i in range(int(clear / 2.5))]


def by(
    direction=lambda angle: (sin(radians(angle)), cos(radians(angle))),
    clear=up_to_the_hit,
    steps=half_cells,
    hit=lambda reading: reading < 170,
    cell=inside,
    put=clamped,
    pass_weight=-0.4,
    once=False,
):
    """What a mistake in one of these leaves in the list."""

    def add_beam(log_odds, x, y, angle, reading):
        dx, dy = direction(angle)
        evidence = [(along, pass_weight) for along in steps(clear(reading))]
        evidence += [(reading, 0.85)] if hit(reading) else []
        seen = set()
        for along, weight in evidence:
            index = cell(x + along * dx, y + along * dy)
            if index is not None and not (once and (index, weight) in seen):
                log_odds[index] = put(log_odds[index], weight)
            seen.add((index, weight))

    return add_beam


def wrapped(x, y):
    return floor(y / 5) * 40 + floor(x / 5)


def wrapped_in_the_list(x, y):
    index = wrapped(x, y)
    return index if 0 <= index < 1600 else None


def one_too_far(x, y):
    column, row = floor(x / 5), floor(y / 5)
    return row * 40 + column if 0 <= column <= 40 and 0 <= row <= 40 else None


def column_alone(x, y):
    return wrapped(x, y) if 0 <= floor(x / 5) < 40 else None


def row_alone(x, y):
    return wrapped(x, y) if 0 <= floor(y / 5) < 40 else None


def truncated(x, y):
    column, row = int(x / 5), int(y / 5)
    return row * 40 + column if 0 <= column < 40 and 0 <= row < 40 else None


def turned_over(x, y):
    return inside(y, x)


BEYOND = "a point off the mat got a cell: check that column and row are both from 0 to ACROSS - 1"

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
        mistake(
            "sine and cosine are the wrong way round: an angle is clockwise from "
            "up the mat, so x goes by sine and y by cosine",
            by(direction=lambda angle: (cos(radians(angle)), sin(radians(angle)))),
            0,
            where=(calls("sin"), calls("cos")),
        ),
        mistake(
            "degrees were taken for radians: math.sin() and math.cos() want math.radians(angle)",
            by(direction=lambda angle: (sin(angle), cos(angle))),
            0,
            where=calls("sin", "cos", "exp", "rect"),
        ),
        (
            "the angle was counted the other way: clockwise means that x grows with the sine",
            by(direction=lambda angle: (sin(radians(-angle)), cos(radians(angle)))),
            0,
        ),
        (
            "row and column are the wrong way round: the cell's number is row * ACROSS + column",
            by(cell=turned_over),
            2,
        ),
        (
            "the steps are a whole cell long and jump over corners: go by half cells",
            by(steps=lambda clear: half_cells(clear)[::2]),
            1,
        ),
        (
            "the steps are a whole cell long and jump over corners: go by half cells",
            by(steps=lambda clear: [i * 5 for i in range(int(clear / 5))]),
            1,
        ),
        (
            "the steps go on to the hit itself: stop one cell short of it",
            by(clear=lambda reading: 170 if reading >= 170 else reading),
            1,
        ),
        mistake(
            "one step too far: go on while you are nearer than the clear length, with < and not <=",
            by(steps=lambda clear: [i * 2.5 for i in range(int(clear / 2.5) + 1)]),
            1,
            where=operator("<="),
        ),
        (
            "the step at 0 cm is missing: the robot stands on floor too, so begin there",
            by(steps=lambda clear: half_cells(clear)[1:]),
            1,
        ),
        (
            "the maximum was taken for a wall: a reading of FAR or more marks no hit",
            by(clear=lambda reading: reading - 5, hit=lambda reading: True),
            1,
        ),
        (
            "a reading of FAR or more marks no hit: it found nothing",
            by(hit=lambda reading: True),
            1,
        ),
        (
            "a reading of exactly FAR has found nothing either: a hit is less than FAR",
            by(
                clear=lambda reading: 170 if reading > 170 else reading - 5,
                hit=lambda reading: reading <= 170,
            ),
            1,
        ),
        (
            "a reading of FAR or more was left out: it says that the floor is free up to FAR",
            by(clear=lambda reading: 0 if reading >= 170 else reading - 5),
            1,
        ),
        (
            "the clear length of a reading of FAR or more is FAR, not the reading",
            by(clear=lambda reading: reading if reading >= 170 else reading - 5),
            1,
        ),
        (
            "the clear length of a reading of FAR or more is FAR, not one cell less",
            by(clear=lambda reading: min(reading, 170) - 5),
            1,
        ),
        (
            "there is no clamp: keep every cell between -L_MAX and L_MAX",
            by(put=lambda before, weight: before + weight),
            2,
        ),
        (
            "only the top is clamped: a cell may not fall below -L_MAX either",
            by(put=lambda before, weight: min(8, before + weight)),
            2,
        ),
        (
            "only the bottom is clamped: a cell may not rise above L_MAX either",
            by(put=lambda before, weight: max(-8, before + weight)),
            2,
        ),
        (
            "the evidence took the place of what was there: add it to the cell's log odds",
            by(put=lambda before, weight: clamped(0, weight)),
            2,
        ),
        mistake(
            "L_FREE was subtracted: it is negative already, so add it",
            by(pass_weight=0.4),
            1,
            where=operator("-"),
        ),
        (
            "a cell is counted once a beam: give it L_FREE at every half-cell step",
            by(once=True),
            1,
        ),
        (
            "the hit is missing: after the floor, L_OCC in the cell where the beam ended",
            by(hit=lambda reading: False),
            2,
        ),
        ("the floor is missing: L_FREE at every half-cell step", by(pass_weight=0), 1),
        (BEYOND, by(cell=wrapped), 2),
        (
            "a point off the mat came out on the other side: check column and row, "
            "not the cell's number",
            by(cell=wrapped_in_the_list),
            2,
        ),
        (
            "only the column is checked: the row has to be from 0 to ACROSS - 1 too",
            by(cell=column_alone),
            2,
        ),
        (
            "only the row is checked: the column has to be from 0 to ACROSS - 1 too",
            by(cell=row_alone),
            2,
        ),
        (BEYOND + " (ACROSS itself is one too many)", by(cell=one_too_far), 2),
        mistake(
            "int() rounds -0.4 to 0, so a point just off the mat gets a cell: use math.floor()",
            by(cell=truncated),
            2,
            where=calls("int"),
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
    task.call(add_beam, EMPTY, 102.5, 41, 0, 27.5)


@check("Beams all round", hint=0)
def all_round(task):
    for angle in (90, 200, 333, -45):
        task.call(add_beam, EMPTY, 103, 71, angle, 20 + 2.5 * task.random.randrange(16))
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


@check("Off the mat there are no cells", hint=2)
def edge(task):
    task.call(add_beam, EMPTY, 189, 102, 90, 12.5)
    task.call(add_beam, EMPTY, 8, 102, -90, 10)
    task.call(add_beam, EMPTY, 102, 189, 0, 12.5)
    task.call(add_beam, EMPTY, 102, 8, 180, 10)
    task.call(add_beam, EMPTY, 151, 102, 60, 200)
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
