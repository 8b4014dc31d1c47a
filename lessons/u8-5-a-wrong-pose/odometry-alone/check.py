"""A map of dark rooms by odometry and scans alone: the drift that is found, the map's score.

The gyros of the rooms drift to either side, some hardly and some a lot, and the robots turn more or
less than they are told: what was told says nothing of the drift, only what was seen does.
"""

from math import hypot

from grader import check

SECONDS, BETWEEN_LOOKS = 48, 0.15
TOLD = 30
"""So fast the robot is told to turn [degrees/s]."""

OFF_BY_CM = 10
"""So far the corrected poses may be off: feet slip, and 0.08 degrees/s are 4 degrees in the end."""


OFF_WAY_CM = 6
"""So far the corrected way may be from the true one: within 4 cm with a drift found as asked."""


def found(run):
    return run.number_after("drift:")


def near_drift(run, times):
    return abs(found(run) - times * run.drift) < 0.08 * abs(times)


def believed_turning(run):
    """How much faster the gyro says it turned than the robot was told [degrees/s]."""
    turned, before = 0.0, run.path[0]
    for pose in run.path[1:]:
        turned += (pose[3] - before[3] + 180) % 360 - 180
        before = pose
    return turned / SECONDS + run.drift - TOLD


SLIPS = [
    (
        "no drift has been found: find_rate() says 0, and the map is as odometry has it",
        lambda run: abs(found(run)) < 0.01,
        0,
    ),
    (
        "that is how much faster the robot turned than it was told: but it does not turn "
        "exactly as it is told, and only what it has seen shows the drift",
        lambda run: abs(found(run) - believed_turning(run)) < 0.1,
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
        "looks are 0.15 s apart, and the rate is per second",
        lambda run: abs(found(run) - BETWEEN_LOOKS * run.drift) < 0.006 and abs(run.drift) > 0.14,
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
        "not one cell is black: the cells above KNOWN are walls, and belong in the layer occupied",
        lambda run: run.map().score.occupied == 0,
    ),
    (
        "the drift is found, but the map has more of it: "
        "take rate * t away, from headings and steps",
        lambda run: run.map().score.wrong_walls_percent > 30,
        2,
    ),
    (
        "the drift is found, but the map still has it: its poses are not the corrected ones",
        lambda run: near_drift(run, 1) and run.map().score.wrong_walls_percent > 15,
        2,
    ),
]


def mapped_well(task, world, seed):
    run = task.run(world, seed=seed, seconds=90, mistakes=SLIPS)
    task.near(found(run), run.drift, 0.08, "the drift in degrees/s", run=run)
    drawn = task.run(world, seed=seed, seconds=90, mistakes=UNUSED).map(off_by=OFF_BY_CM)
    drawn.cells_of(5).known(at_least=65).wrong_walls(at_most=6).wrong_floor(at_most=2)
    drawn.walls_found(at_least=60)
    way = run.layer("way")
    true = [run.pose_at(BETWEEN_LOOKS * look) for look in range(len(way))]
    worst = max((hypot(x - a, y - b) for (x, y), (a, b, _) in zip(way, true)), default=1000)
    task.expect(
        worst < OFF_WAY_CM,
        expected=f"the corrected way within {OFF_WAY_CM} cm of the true one all along",
        got=f"{worst:.1f} cm away at its worst",
        run=run,
    )


@check("The hall at night, with other noise", hint=0)
def hall(task):
    mapped_well(task, "hall-at-night", 71)


@check("A cellar", hint=1)
def cellar(task):
    mapped_well(task, "cellar", 72)


@check("An attic", hint=1)
def attic(task):
    mapped_well(task, "attic", 73)


@check("A store room", hint=1)
def store_room(task):
    mapped_well(task, "store-room", 74)


@check("A crypt", hint=1)
def crypt(task):
    mapped_well(task, "crypt", 75)
