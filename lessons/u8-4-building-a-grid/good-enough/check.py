"""Any route: how much of the mat is known at the end, how much of it is wrong, how long it took."""

from math import hypot

from grader import calls, check, mistake

KNOWN = 1


def driven(run):
    """How far the robot went [cm]."""
    return sum(hypot(b[1] - a[1], b[2] - a[2]) for a, b in zip(run.path, run.path[1:]))


def reach(run, axis):
    """How far apart the places are that it has been to, along x (1) or y (2) [cm]."""
    places = [each[axis] for each in run.path]
    return max(places) - min(places)


def blind(run):
    """The longest way it went from one look to the next [cm]."""
    return max((hypot(b.x - a.x, b.y - a.y) for a, b in zip(run.scans, run.scans[1:])), default=0)


def ways(run):
    """Into how many eighths of the compass it has looked."""
    return len({int(scan.heading // 45) for scan in run.scans})


SLIPS = [
    (
        "not one cell is black: the cells above KNOWN are walls, and belong in the layer occupied",
        lambda run: run.map().score.occupied == 0,
    ),
    (
        "everything was seen from one place: what stands behind "
        "furniture stays hidden until you drive round it",
        lambda run: driven(run) < 20,
        0,
    ),
    (
        "no look on the way: forward() with a distance waits until "
        "it is driven, so go on looking while it drives",
        lambda run: blind(run) > 15,
        1,
    ),
    (
        "the robot looks only where it drives: the sensor "
        "sees 45 degrees, so look round at the stops",
        lambda run: ways(run) < 8,
        1,
    ),
    mistake(
        "sine and cosine look swapped on the way to a goal: a "
        "heading is math.atan2(dx, dy), with x first",
        lambda run: reach(run, 1) > reach(run, 2) and max(y for _, _, y, _ in run.path) < 60,
        2,
        where=calls("sin", "cos", "atan2"),
    ),
    (
        "it took too long: turn faster, and look round at fewer places",
        lambda run: run.seconds > 75,
        2,
    ),
    (
        "the robot stayed on one arm of the cross: from there, furniture hides what is behind it",
        lambda run: min(reach(run, 1), reach(run, 2)) < 30,
        0,
    ),
]


def good_enough(task, world, seed):
    run = task.run(world, seed=seed, seconds=120, mistakes=SLIPS)
    run.took(at_most=75)
    drawn = run.map(known=KNOWN)
    drawn.cells_of(5).known(at_least=85).wrong_walls(at_most=5)
    # Limits with room for every sound rule: lessons/README.md, "How maps are judged".
    drawn.wrong_floor(at_most=1).walls_found(at_least=60)
    drawn.plain(floor_at_least=95, walls_at_least=85)


@check("The room of the page, with other noise", hint=0)
def workshop(task):
    good_enough(task, "workshop", 51)


@check("A gallery", hint=0)
def gallery(task):
    good_enough(task, "gallery", 52)


@check("A garage", hint=1)
def garage(task):
    good_enough(task, "garage", 53)


@check("A library", hint=2)
def library(task):
    good_enough(task, "library", 54)
