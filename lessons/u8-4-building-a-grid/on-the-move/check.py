"""A map from a robot that drives a circle, on the mat of the page and on hidden ones."""

from grader import check

KNOWN = 1


def slip(said, hint, seen_as):
    """A slip that shows in the map: how the readings would have been seen."""
    return (said, lambda run: run.map().looks_like(run.mapped(seen_as=seen_as)), hint)


SLIPS = [
    (
        "no time passes between the looks, so the robot never moves: the loop needs a wait(0.1)",
        lambda run: run.seconds < 1,
        2,
    ),
    (
        "the robot drives far without a look: look, wait a tenth "
        "of a second, and look again, all the way round",
        lambda run: len(run.scans) < 30,
        2,
    ),
    slip(
        "position() is from where the robot started: add START to get the place on the mat",
        1,
        lambda x, y, heading, angle, reading: (x - 72, y - 100, heading, angle, reading),
    ),
    slip(
        "the place is that of the start, not of now: ask position() at every look",
        0,
        lambda x, y, heading, angle, reading: (72, 100, heading, angle, reading),
    ),
    slip(
        "the pose is that of the start, not of now: ask position() and heading() at every look",
        0,
        lambda x, y, heading, angle, reading: (72, 100, 0, angle, reading),
    ),
    slip(
        "the heading is left out: a beam's direction is heading() + angle",
        1,
        lambda x, y, heading, angle, reading: (x, y, 0, angle, reading),
    ),
    slip(
        "the fan is the wrong way round: angles are positive "
        "to the right, so it is heading() + angle",
        1,
        lambda x, y, heading, angle, reading: (x, y, heading, -angle, reading),
    ),
    slip(
        "x and y look swapped: position() gives x first",
        1,
        lambda x, y, heading, angle, reading: (72 + y - 100, 100 + x - 72, heading, angle, reading),
    ),
]


def mapped_well(task, world, seed, known):
    run = task.run(world, seed=seed, seconds=40, mistakes=SLIPS)
    run.scanned(at_least=60).visits(lambda x, y: x > 115, "the far side of the circle")
    drawn = run.map(known=KNOWN)
    drawn.cells_of(5).known(at_least=known).wrong_walls(at_most=4).wrong_floor(at_most=1)
    # Limits with room for every sound rule: lessons/README.md, "How maps are judged".
    drawn.walls_found(at_least=60).plain(floor_at_least=92, walls_at_least=90)


@check("The ring of the page, with other noise", hint=0)
def same_ring(task):
    mapped_well(task, "carousel", 41, known=65)


@check("A ring with curtains", hint=1)
def stage(task):
    mapped_well(task, "stage", 42, known=59)


@check("A ring with jars", hint=1)
def pantry(task):
    mapped_well(task, "pantry", 43, known=69)
