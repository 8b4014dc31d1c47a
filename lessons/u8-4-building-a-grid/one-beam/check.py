"""add_beam(log_odds, x, y, angle, reading): what one beam says, added to a flat list."""

from math import cos, degrees, floor, radians, sin

from grader import check, function, near
from mapping.beam import Weights, passed_by_steps
from mapping.mapper import Mapper


def by(weights=None, passed_by=passed_by_steps, seen_as=lambda x, y, angle: (x, y, angle)):
    """The reference, or a slip of it."""

    def add_beam(log_odds, x, y, angle, reading):
        mapper = Mapper(5, weights or Weights(), passed_by)
        mapper.grid.cells = log_odds
        mapper.add_beam(*seen_as(x, y, angle), reading)

    return add_beam


def whole_cells(x, y, angle, length, cell):
    return passed_by_steps(x, y, angle, length, cell)[::2][: int(length / cell)]


def into_the_hit(x, y, angle, length, cell):
    return passed_by_steps(x, y, angle, length + cell if length < 165 else length, cell)


def one_more(x, y, angle, length, cell):
    return passed_by_steps(x, y, angle, length + cell / 2, cell)


def each_once(x, y, angle, length, cell):
    return list(dict.fromkeys(passed_by_steps(x, y, angle, length, cell)))


def hit_at(place):
    """A slip in where the hit goes: place(x, y) gives its number in the list, or None."""

    def add_beam(log_odds, x, y, angle, reading):
        by(Weights(l_occ=0))(log_odds, x, y, angle, reading)
        end = x + reading * sin(radians(angle)), y + reading * cos(radians(angle))
        index = place(*end) if reading < 170 else None
        if index is not None:
            log_odds[index] = min(8, log_odds[index] + 0.85)

    return add_beam


def wrapped(x, y):
    return floor(y / 5) * 40 + floor(x / 5)


def truncated(x, y):
    column, row = int(x / 5), int(y / 5)
    return row * 40 + column if 0 <= column < 40 and 0 <= row < 40 else None


add_beam = function(
    "add_beam(log_odds, x, y, angle, reading)",
    by(),
    changes="log_odds",
    grid_cm=5,
    compare=near(0.0001),
    mistakes=[
        (
            "sine and cosine look swapped: an angle is clockwise from "
            "up the mat, so x goes by sine and y by cosine",
            by(seen_as=lambda x, y, angle: (x, y, 90 - angle)),
            0,
        ),
        (
            "degrees look taken for radians: math.sin() and math.cos() want math.radians(angle)",
            by(seen_as=lambda x, y, angle: (x, y, degrees(angle))),
            0,
        ),
        (
            "row and column look swapped: the cell's number is row * ACROSS + column",
            by(seen_as=lambda x, y, angle: (y, x, 90 - angle)),
            2,
        ),
        (
            "whole-cell steps: a step of CELL jumps over corners; go by half cells",
            by(passed_by=whole_cells),
            1,
        ),
        (
            "the hit cell is marked free as well: stop one cell short of the hit",
            by(passed_by=into_the_hit),
            1,
        ),
        (
            "one step too far: go on while you are nearer than the clear length, with < and not <=",
            by(passed_by=one_more),
            1,
        ),
        (
            "the maximum is taken for a wall: a reading of FAR or more marks no hit",
            by(Weights(far_cm=1000)),
            1,
        ),
        ("there is no clamp: keep every cell between -L_MAX and L_MAX", by(Weights(l_max=1000)), 2),
        (
            "a cell is counted once a beam: give it L_FREE at every half-cell step",
            by(passed_by=each_once),
            1,
        ),
        (
            "the hit is missing: after the floor, L_OCC in the cell where the beam ended",
            by(Weights(l_occ=0)),
            2,
        ),
        (
            "the floor is missing: L_FREE at every half-cell step on the way",
            by(Weights(l_free=0)),
            1,
        ),
        (
            "a cell beyond the mat came out on the other side: check "
            "that column and row are from 0 to ACROSS - 1",
            hit_at(wrapped),
            2,
        ),
        (
            "int() rounds -0.4 to 0, so a point beyond the edge gets a cell: use math.floor()",
            hit_at(truncated),
            2,
        ),
    ],
)

EMPTY = [0.0] * 1600


@check("A beam straight up the mat", hint=0)
def up(task):
    task.call(add_beam, EMPTY, 102.5, 42.5, 0, 27.5)


@check("Beams all round", hint=0)
def all_round(task):
    for angle in (90, 200, 333, -45):
        # Clear for a whole number of steps: int(clear / step) and a loop with < then agree.
        task.call(add_beam, EMPTY, 102.5, 71, angle, 20 + 2.5 * task.random.randrange(16))


@check("A reading of nothing", hint=1)
def nothing(task):
    task.call(add_beam, EMPTY, 12.5, 12.5, 45, 200)
    task.call(add_beam, EMPTY, 12.5, 12.5, 44, 171)


@check("The clamp", hint=2)
def clamp(task):
    task.call(add_beam, [7.9] * 1600, 52.5, 52.5, 0, 22.5)
    task.call(add_beam, [-7.9] * 1600, 52.5, 52.5, 0, 22.5)


@check("Beyond the mat is no cell", hint=2)
def edge(task):
    task.call(add_beam, EMPTY, 190, 102.5, 90, 12.5)
    task.call(add_beam, EMPTY, 8, 102.5, -90, 10)
