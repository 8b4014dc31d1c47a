"""The project: three mats that nobody has seen, two noises each, within limits."""

from grader import check, scoring
from mapping.reasons import Stop, Untrue, reason_in, untrue

KNOWN = 0.62
"""Beyond these log odds of its beams, p = 0.65, a cell counts as known."""

MOST_WAY_CM = 1700
"""So far a run may drive: 1 m more than the programs allow themselves."""

FAR_ENOUGH_CM = 1500
TIME_IS_UP_S = 100
"""From here on these two reasons can be true, on every mat."""

POINTS = scoring(
    "Each run counts the per cent of the mat that its map knows and its beams bear out, less 1 for "
    "each per cent of the mat that it draws though they don't, less 2 for each per cent of wrong "
    "walls and of wrong floor, less 1 for each 5 per cent of the walls not found and for each "
    "10 s. "
    "A run that does not end by itself counts 0. The score is the mean of the six runs.",
    lambda run, drawn: (
        drawn.backed_percent
        - drawn.unsupported_percent
        - 2 * drawn.score.wrong_walls_percent
        - 2 * drawn.score.wrong_floor_percent
        - (100 - drawn.walls_found_percent) / 5
        - run.seconds / 10
    ),
    of=100,
)

REASONS = (
    "no frontier is left",
    "only small frontiers are left",
    "no frontier can be reached",
    "it has driven far enough",
    "time is up",
)


def holds(said, run, drawn):
    """Whether the reason for stopping is one, and true."""
    reason = reason_in(said)
    if reason is None:
        return Untrue(
            'one of the reasons of the table in "Knowing when to stop", such as '
            f'"{REASONS[0]}" or "{REASONS[-1]}"',
            "that is none of them",
        )
    path = [(x, y) for _, x, y, _ in run.path]
    stop = Stop(drawn.grid, drawn.states, path, run.distance_cm, run.seconds)
    return untrue(reason, stop, far_cm=FAR_ENOUGH_CM, time_s=TIME_IS_UP_S)


def still_percent(run):
    """The share of its time that it stood on one place, turning or not [%]."""
    still = sum(
        b[0] - a[0] for a, b in zip(run.path, run.path[1:], strict=False) if a[1:3] == b[1:3]
    )
    return 100 * still / max(1, run.seconds)


def knows_little(run, known):
    """Whether its map leaves much unknown that is not just left out of the drawing."""
    drawn = run.map(known=KNOWN)
    return drawn.score.known_percent < known and drawn.walls_found_percent > 55


def mistakes(known, seconds):
    """What can be told for certain of a run that is outside its limits."""
    return [
        (
            "the robot never left its start: drive to where the frontier is",
            lambda run: run.distance_cm < 20,
            0,
        ),
        (
            "not one cell is black: the cells above KNOWN are walls",
            lambda run: run.map().score.occupied == 0,
            0,
        ),
        (
            "it stopped too soon: look at the frontier cells that are left, and ask why it "
            "leaves them",
            lambda run: knows_little(run, known) and run.seconds < seconds,
            1,
        ),
        (
            "the robot runs into things: keep more room to walls, and back off when it is stuck",
            lambda run: run.bumps > 2,
            1,
        ),
        (
            "it stood still for more than half of its time: look while it drives, and turn "
            "while it drives",
            lambda run: run.seconds > seconds and still_percent(run) > 50,
            2,
        ),
        (
            "it drove to and fro: plan from where it is, and go to what is near first",
            lambda run: run.distance_cm > MOST_WAY_CM,
            1,
        ),
    ]


def within_limits(task, world, known, seconds):
    for trial in task.trials(
        world,
        seeds=(1, 2),
        seconds=300,
        mistakes=mistakes(known, seconds),
        scored=POINTS,
        known=KNOWN,
    ):
        trial.known(at_least=known).wrong_walls(at_most=3).wrong_floor(at_most=2)
        # Limits with room for every sound rule: lessons/README.md, "How maps are judged".
        trial.walls_found(at_least=55).unsupported(at_most=6)
        trial.took(at_most=seconds).drove(at_most=MOST_WAY_CM).bumps(at_most=2)
        trial.says_why(after="stops:", holds=holds)


@check("Rooms and their doorways", hint=0)
def rooms(task):
    within_limits(task, "flat", known=93, seconds=110)


@check("Clutter", hint=1)
def clutter(task):
    within_limits(task, "lumber-room", known=90, seconds=130)


@check("Dead ends", hint=2)
def dead_ends(task):
    within_limits(task, "burrow", known=95, seconds=175)
