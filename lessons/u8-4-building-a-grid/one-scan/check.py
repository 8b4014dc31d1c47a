"""add_scan(log_odds, x, y, facing, readings): eight beams, each at its own angle."""

from grader import check, function, near
from mapping.mapper import Mapper


def by(turned=lambda facing, angle: facing + angle, which=slice(None), at=lambda x, y: (x, y)):
    """The reference, or a slip of it."""

    def add_scan(log_odds, x, y, facing, readings):
        mapper = Mapper(5)
        mapper.grid.cells = log_odds
        for angle, reading in readings[which]:
            mapper.add_beam(*at(x, y), turned(facing, angle), reading)

    return add_scan


add_scan = function(
    "add_scan(log_odds, x, y, facing, readings)",
    by(),
    changes="log_odds",
    grid_cm=5,
    compare=near(0.0001),
    mistakes=[
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
        (
            "only the last beam is added: the call of "
            "add_beam() must stand inside the loop, indented",
            by(which=slice(-1, None)),
            0,
        ),
        (
            "the last beam is missing: go through readings itself, for angle, reading in readings",
            by(which=slice(0, -1)),
            0,
        ),
        ("x and y look swapped: add_beam() wants x first", by(at=lambda x, y: (y, x)), 2),
    ],
)

EMPTY = [0.0] * 1600
FAN = [-19.6875, -14.0625, -8.4375, -2.8125, 2.8125, 8.4375, 14.0625, 19.6875]


@check("A robot that faces up the mat", hint=0)
def up(task):
    readings = [30.0, 34.0, 38.0, 42.0, 46.0, 50.0, 54.0, 200.0]
    task.call(add_scan, EMPTY, 81.0, 52.5, 0, [list(pair) for pair in zip(FAN, readings)])


@check("A robot that faces right", hint=1)
def right(task):
    task.call(add_scan, EMPTY, 61.0, 102.5, 90, [[angle, 40 + angle] for angle in FAN])


@check("Any heading, and a map that has been begun", hint=1)
def any_heading(task):
    begun = [-2.0] * 1600
    for _ in range(3):
        facing = task.random.uniform(20, 340)
        readings = [[angle, task.random.uniform(20, 60)] for angle in FAN]
        task.call(add_scan, begun, 102.5, 88.0, facing, readings)
