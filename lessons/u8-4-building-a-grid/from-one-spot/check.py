"""A map from one spot, on the mat of the page and on mats nobody has seen."""

from grader import check
from mapping.beam import Weights, passed_by_bresenham, passed_by_steps


def whole_cells(x, y, angle, length, cell):
    return passed_by_steps(x, y, angle, length, cell)[::2][: int(length / cell)]


def into_the_hit(x, y, angle, length, cell):
    return passed_by_steps(x, y, angle, length + cell if length < 165 else length, cell)


def slip(said, hint, **how):
    """A slip that shows in the map: how the reference would have to be changed to draw it."""
    return (said, lambda run: run.map().looks_like(run.mapped(**how)), hint)


SLIPS = [
    (
        "no time passes, so the robot never turns: the loop needs its wait(0.1)",
        lambda run: run.seconds < 1,
        2,
    ),
    slip(
        "sine and cosine look swapped: x goes by sine and y by cosine",
        0,
        seen_as=lambda x, y, heading, angle, reading: (x, y, 90 - heading, -angle, reading),
    ),
    slip(
        "the heading is left out: a beam's direction is heading() + angle",
        1,
        seen_as=lambda x, y, heading, angle, reading: (x, y, 0, angle, reading),
    ),
    slip(
        "position() is from where the robot started: add START to get the place on the mat",
        1,
        seen_as=lambda x, y, heading, angle, reading: (x - 45, y - 30, heading, angle, reading),
    ),
    slip(
        "row and column look swapped: cell number row * ACROSS + column",
        2,
        seen_as=lambda x, y, heading, angle, reading: (y, x, 90 - heading, -angle, reading),
    ),
    slip(
        "the maximum is taken for a wall: a reading of FAR or more marks no hit",
        0,
        weights=Weights(far_cm=1000),
    ),
    slip(
        "readings of FAR or more are thrown away: they mark "
        "no wall, but their floor is free up to FAR",
        0,
        seen_as=lambda x, y, heading, angle, reading: (
            (x, y, heading, angle, reading) if reading < 170 else None
        ),
    ),
    slip(
        "whole-cell steps: a step of CELL jumps over corners; go by half cells",
        0,
        passed_by=whole_cells,
    ),
    slip(
        "the hit cell is marked free as well: stop one cell short of the hit",
        0,
        passed_by=into_the_hit,
    ),
    slip(
        "the hits are never added: L_OCC goes into the cell where the beam ended",
        0,
        weights=Weights(l_occ=0),
    ),
    slip(
        "the passes are never added: L_FREE goes into the cells on the way",
        0,
        weights=Weights(l_free=0),
    ),
    slip(
        "the layers show every cell that has any evidence: known means beyond KNOWN, either way",
        2,
        known=0.001,
    ),
]


def mapped_well(task, world, seed, known):
    run = task.run(world, seed=seed, seconds=30, mistakes=SLIPS)
    drawn = run.map()
    drawn.cells_of(5).known(at_least=known).wrong_walls(at_most=4)
    # Either way to list the cells of a beam will do.
    said = (run.mapped(), run.mapped(passed_by=passed_by_bresenham))
    drawn.agrees(max(said, key=drawn.agreement), at_least=95)


@check("The room of the page, with other noise", hint=0)
def same_room(task):
    mapped_well(task, "corner-room", 31, known=54)


@check("A den, the robot facing right", hint=1)
def den(task):
    mapped_well(task, "den", 32, known=60)


@check("A stock room, the robot facing down and left", hint=1)
def stock_room(task):
    mapped_well(task, "stock-room", 33, known=47)
