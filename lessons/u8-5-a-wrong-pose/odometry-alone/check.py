"""A map of dark rooms by odometry and scans alone: the drift that is found, the map's score."""

from grader import check

SECONDS = 48


def found(run):
    return run.number_after("drift:")


def near_drift(run, times):
    return abs(found(run) - times * run.drift) < 0.06 * abs(times)


SLIPS = [
    (
        "no drift has been found: find_rate() says 0, and the map is as odometry has it",
        lambda run: abs(found(run)) < 0.01,
        0,
    ),
    (
        "the sign is turned round: the drift is what the believed heading has too much",
        lambda run: near_drift(run, -1),
        1,
    ),
    (
        "the rate is at an end of those tried: the sharpest map "
        "has the fewest cells with a hit, and corrected() must change the poses",
        lambda run: abs(abs(found(run)) - 0.4) < 0.03,
        1,
    ),
    (
        "that is the drift from one look to the next: "
        "looks are 0.2 s apart, and the rate is per second",
        lambda run: abs(found(run) - 0.2 * run.drift) < 0.012,
        0,
    ),
    (
        "that is the drift of the whole run: divide by its seconds",
        lambda run: near_drift(run, SECONDS),
        0,
    ),
]

UNUSED = [
    *SLIPS,
    (
        "the drift is found, but the map has more of it: "
        "take rate * t away, from headings and steps",
        lambda run: run.map().score.wrong_walls_percent > 30,
        2,
    ),
    (
        "the drift is found, but the map still has it: its poses are not the corrected ones",
        lambda run: near_drift(run, 1),
        2,
    ),
]


def mapped_well(task, world, seed):
    run = task.run(world, seed=seed, seconds=90, mistakes=SLIPS)
    task.near(found(run), run.drift, 0.06, "the drift in degrees/s", run=run)
    drawn = task.run(world, seed=seed, seconds=90, mistakes=UNUSED).map()
    drawn.cells_of(5).known(at_least=65).wrong_walls(at_most=4)


@check("The hall at night, with other noise", hint=0)
def hall(task):
    mapped_well(task, "hall-at-night", 71)


@check("A cellar", hint=1)
def cellar(task):
    mapped_well(task, "cellar", 72)
