"""add_scan(log_odds, x, y, facing, readings): eight beams, each at its own angle.

Each clear length is a whole number of steps, so that any sound count of steps in a
beam of one's own gives the same. The program turns by 45 degrees itself, so
heading() is 45 when the function is called.
"""

from math import radians

from grader import calls, check, function, loops, mistake, near
from mapping.mapper import Mapper


def by(turned=lambda facing, angle: facing + angle, which=slice(None), at=lambda x, y: (x, y)):
    """The reference, or a slip of it."""

    def add_scan(log_odds, x, y, facing, readings):
        mapper = Mapper(5)
        mapper.grid.cells = log_odds
        for angle, reading in readings[which]:
            mapper.add_beam(*at(x, y), turned(facing, angle), reading)

    return add_scan


def by_fixed_angles(log_odds, x, y, facing, readings):
    pairs = [(FAN[0] + 5.625 * i, reading) for i, (_, reading) in enumerate(readings)]
    by()(log_odds, x, y, facing, pairs)


add_scan = function(
    "add_scan(log_odds, x, y, facing, readings)",
    by(),
    changes="log_odds",
    grid_cm=5,
    compare=near(0.0001),
    mistakes=[
        (
            "the angles were worked out: take each from readings, beside its distance",
            by_fixed_angles,
            1,
        ),
        mistake(
            "add_beam() got radians: it wants degrees, and turns them into radians itself",
            by(lambda facing, angle: radians(facing + angle)),
            2,
            where=calls("radians", "deg2rad", "pi"),
        ),
        mistake(
            "heading() was added to facing: facing is the heading already, so add it once",
            by(lambda facing, angle: 45 + facing + angle),
            1,
            where=calls("heading"),
        ),
        mistake(
            "heading() tells the heading at this moment: in the scan the robot faced facing",
            by(lambda facing, angle: 45 + angle),
            1,
            where=calls("heading"),
        ),
        (
            "the heading is left out: a beam's angle is from straight ahead, so add facing to it",
            by(lambda facing, angle: angle),
            1,
        ),
        (
            "all beams go straight ahead: each has its own angle, to be added to facing",
            by(lambda facing, angle: facing),
            1,
        ),
        (
            "the fan is the wrong way round: angles are "
            "positive to the right, so it is facing + angle",
            by(lambda facing, angle: facing - angle),
            2,
        ),
        (
            "the heading counts the wrong way: it is facing + angle",
            by(lambda facing, angle: angle - facing),
            2,
        ),
        (
            "only the first beam is added: add_beam() belongs inside "
            "the loop, and nothing may leave the loop early",
            by(which=slice(0, 1)),
            0,
        ),
        mistake(
            "only the last beam is added: the call of "
            "add_beam() must stand inside the loop, indented",
            by(which=slice(-1, None)),
            0,
            where=loops(),
        ),
        (
            "the last beam is missing: go through readings itself, for angle, reading in readings",
            by(which=slice(0, -1)),
            0,
        ),
        (
            "x and y are the wrong way round: add_beam() wants x first",
            by(at=lambda x, y: (y, x)),
            2,
        ),
    ],
)

EMPTY = [0.0] * 1600
FAN = [-19.6875, -14.0625, -8.4375, -2.8125, 2.8125, 8.4375, 14.0625, 19.6875]


@check("A robot that faces up the mat", hint=0)
def up(task):
    readings = [30.0, 35.0, 37.5, 42.5, 45.0, 50.0, 55.0, 200.0]
    task.call(add_scan, EMPTY, 81.0, 52.5, 0, [list(pair) for pair in zip(FAN, readings)])


@check("A robot that faces right", hint=1)
def right(task):
    task.call(
        add_scan, EMPTY, 61.0, 102.5, 90, [[angle, 30 + 5 * i] for i, angle in enumerate(FAN)]
    )


@check("Eight other angles", hint=1)
def other_angles(task):
    readings = [[-70.0 + 20 * i, 30.0 + 2.5 * i] for i in range(8)]
    task.call(add_scan, EMPTY, 101.0, 92.5, 10, readings)


@check("Three beams, and eleven", hint=0)
def other_numbers(task):
    for number in (3, 11):
        readings = [[-50.0 + 10 * i, 30.0 + 2.5 * i] for i in range(number)]
        task.call(add_scan, EMPTY, 101.0, 92.5, 75, readings)


@check("Any heading, and a map that has been begun", hint=1)
def any_heading(task):
    begun = [-2.0] * 1600
    for _ in range(3):
        facing = task.random.uniform(20, 340)
        readings = [[angle, 20 + 2.5 * task.random.randrange(16)] for angle in FAN]
        task.call(add_scan, begun, 102.5, 88.0, facing, readings)
