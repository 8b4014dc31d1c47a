"""The project: three mats that nobody has seen, two noises each, within limits."""

from grader import check, scoring

MOST_WAY_CM = 1700
"""So far a run may drive: 1 m more than the programs allow themselves."""

POINTS = scoring(
    "Each run counts the per cent known, less 2 for each per cent of wrong walls and 1 for each "
    "10 s. A run that does not end by itself counts 0. The score is the mean of the six runs.",
    lambda run, drawn: (
        drawn.score.known_percent - 2 * drawn.score.wrong_walls_percent - run.seconds / 10
    ),
    of=100,
)


def turning_only(run):
    """The share of its time that it stood on one place [%]."""
    still = sum(
        b[0] - a[0] for a, b in zip(run.path, run.path[1:], strict=False) if a[1:3] == b[1:3]
    )
    return 100 * still / max(1, run.seconds)


SLIPS = [
    (
        "the robot never left its start: drive to where the frontier is",
        lambda run: run.distance_cm < 20,
        0,
    ),
    (
        "the robot runs into things: keep more room to walls, and back off when it is stuck",
        lambda run: run.bumps > 2,
        1,
    ),
    (
        "it stood still for more than half of its time: look while it drives, and turn "
        "while it drives",
        lambda run: run.seconds > 60 and turning_only(run) > 50,
        2,
    ),
    (
        "it drove to and fro: plan from where it is, and go to what is near first",
        lambda run: run.distance_cm > MOST_WAY_CM,
        1,
    ),
    (
        "it stopped too soon: look at the frontier cells that are left, and ask why it leaves them",
        lambda run: run.map().score.known_percent < 85 and run.seconds < 130,
        1,
    ),
]


def within_limits(task, world, known, seconds):
    for trial in task.trials(world, seeds=(1, 2), seconds=300, mistakes=SLIPS, scored=POINTS):
        trial.known(at_least=known).wrong_walls(at_most=3).took(at_most=seconds)
        trial.drove(at_most=MOST_WAY_CM).bumps(at_most=2).says_why(after="stops:")


@check("Rooms and their doorways", hint=0)
def rooms(task):
    within_limits(task, "flat", known=93, seconds=110)


@check("Clutter", hint=1)
def clutter(task):
    within_limits(task, "lumber-room", known=90, seconds=130)


@check("Dead ends", hint=2)
def dead_ends(task):
    within_limits(task, "burrow", known=95, seconds=175)
