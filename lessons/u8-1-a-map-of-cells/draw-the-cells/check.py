"""The layer "visited": every cell of 5 cm the robot has been in, and no other."""

from itertools import pairwise
from math import cos, floor, radians, sin

from grader import calls, check, lacks, mistake, operator, reads

CELL = 5


def cell(x, y):
    return floor(x / CELL), floor(y / CELL)


def middle(column, row):
    return (column + 0.5) * CELL, (row + 0.5) * CELL


def been_in(path):
    """The cells of a path, each with the seconds that the robot spent there."""
    seconds = {}
    for (t0, x0, y0, _), (t1, x1, y1, _) in pairwise(path):
        here = cell(x0, y0)
        seconds.setdefault(here, 0.0)
        if here == cell(x1, y1):
            seconds[here] += t1 - t0
    return seconds


def drawn(run):
    return {(round(x, 3), round(y, 3)) for x, y in run.layer("visited")}


def looks_like(run, path, place=middle):
    """Whether the cells of this path, drawn by `place`, are what was drawn (but for a few)."""
    ought, is_drawn = {place(*each) for each in been_in(path)}, drawn(run)
    return len(ought) > 4 and len(ought ^ is_drawn) <= 0.1 * len(ought)


def without_start(path):
    """The path as position() gives it, where that happens to be a place on the mat."""
    moved = [(t, x - 100, y - 100, heading) for t, x, y, heading in path]
    return [place for place in moved if place[1] >= 0 and place[2] >= 0]


def as_planned():
    """The path if nothing had stood in the way: a circle, 18 degrees a second."""
    radius = 0.70 * 11.5 / radians(18)
    angles = [(t / 25, radians(18 * t / 25)) for t in range(501)]
    return [(t, 100 + radius * (1 - cos(a)), 100 + radius * sin(a), 0) for t, a in angles]


def moved(run, dx, dy):
    """The path with the way from the start taken otherwise: `dx` and `dy` times."""
    x0, y0 = run.start.x, run.start.y
    return [(t, x0 + dx * (x - x0), y0 + dy * (y - y0), h) for t, x, y, h in run.path]


MISTAKES = [
    mistake(
        "odometry() is what the robot believes, and it drifts: position() says where it is",
        lambda run: True,
        0,
        where=(calls("odometry"), lacks(calls("position"))),
    ),
    (
        "nothing is drawn: show has to collect the middles of all cells that are True in visited, "
        "and mark has to set them",
        lambda run: not drawn(run),
        2,
    ),
    (
        "only one cell is drawn: either mark does not ask position() each time or keep what it has "
        "marked, or show draws only one of the cells that are True",
        lambda run: len(drawn(run)) == 1,
        0,
    ),
    (
        "every cell is drawn: pick those whose value in visited is True",
        lambda run: len(drawn(run)) == 1600,
        0,
    ),
    mistake(
        "START was not added: position() counts from where the robot started, not from the corner "
        "of the mat",
        lambda run: looks_like(run, without_start(run.path)),
        1,
        where=lacks(reads("START")),
    ),
    mistake(
        "position() was subtracted: add it to START",
        lambda run: looks_like(run, moved(run, -1, -1)),
        1,
        where=(calls("position"), operator("-")),
    ),
    (
        "drawn at the lower left corner of each cell: squares are placed by their middle",
        lambda run: looks_like(run, run.path, lambda column, row: (column * CELL, row * CELL)),
        2,
    ),
    (
        "column and row are drawn, not in cm: multiply them by CELL",
        lambda run: looks_like(run, run.path, lambda column, row: (column + 0.5, row + 0.5)),
        2,
    ),
    (
        "column and row are drawn, not in cm: the middle is at (column + 0.5) * CELL",
        lambda run: looks_like(run, run.path, lambda column, row: (column, row)),
        2,
    ),
    (
        "x and y, or column and row, are the wrong way round: position() and index_of have x "
        "first; column is index % ACROSS, row is index // ACROSS",
        lambda run: looks_like(run, run.path, lambda column, row: middle(row, column)),
        2,
    ),
    (
        "that is where the robot would be if nothing stood in its way: ask position() instead",
        lambda run: looks_like(run, as_planned()),
        0,
    ),
]


def compare(task, world):
    run = task.run(world, seed=1, seconds=60, mistakes=MISTAKES)
    seconds = been_in(run.path)
    long_enough = [each for each in seconds if seconds[each] > 0.25]
    missing = [each for each in long_enough if middle(*each) not in drawn(run)]
    extra = drawn(run) - {middle(*each) for each in seconds}
    task.expect(
        not missing,
        expected=f"the {len(long_enough)} cells where the robot has been for a while, all drawn",
        got=f"{len(missing)} of them are missing",
        run=run,
        cells=missing,
        cell_cm=CELL,
    )
    task.expect(
        not extra,
        expected="no cell drawn where the robot has not been",
        got=f"{len(extra)} such cell{'' if len(extra) == 1 else 's'}",
        run=run,
        cells=[cell(x, y) for x, y in sorted(extra)],
        cell_cm=CELL,
    )


@check("The robot drives in a circle", hint=0)
def circle(task):
    compare(task, "empty")


@check("Something stands in its way", hint=0)
def stopped(task):
    compare(task, "in-the-way")


@check("A wall above its circle", hint=1)
def wall(task):
    compare(task, "round-the-corner")
