"""The chart's four lines, look by look, held against what the readings say."""

from math import exp, floor

from grader import check
from mapping.beam import clear_length, end_of_hit, passed_by_steps

CELLS = {
    "floor": (102.5, 122.5),
    "in front": (102.5, 147.5),
    "wall": (102.5, 152.5),
    "behind": (102.5, 177.5),
}


def clamp(l):
    return max(-8, min(8, l))


def retold(run, x, y, rule, shown):
    """The cell's line if every beam changed its log odds by `rule(l, passes, hit)`."""
    l, cell = 0.0, (floor(x / 5), floor(y / 5))
    for scan in run.scans:
        for angle, reading in scan.beams:
            beam = (scan.x, scan.y, scan.heading + angle)
            passes = passed_by_steps(*beam, clear_length(reading, 5), 5).count(cell)
            end = end_of_hit(*beam, reading)
            hit = end is not None and (floor(end[0] / 5), floor(end[1] / 5)) == cell
            l = rule(l, passes, hit)
        yield shown(l)


def slip(said, rule, shown=lambda l: l, hint=None, turned=False):
    """A slip, by what it makes of the four lines."""

    def explains(run):
        return all(
            abs(value - told) < 0.02
            for name, (x, y) in CELLS.items()
            for (_, value), told in zip(
                run.line(name).points,
                retold(run, y if turned else x, x if turned else y, rule, shown),
            )
        )

    return (said, explains) if hint is None else (said, explains, hint)


def right(l, passes, hit):
    return clamp(l - 0.4 * passes + 0.85 * hit)


SLIPS = [
    slip(
        "there is no clamp: add(), after adding, must keep log_odds[cell] between -L_MAX and L_MAX",
        lambda l, passes, hit: l - 0.4 * passes + 0.85 * hit,
        hint=0,
    ),
    slip(
        "clamped only at the top: floor needs a limit too, at -L_MAX",
        lambda l, passes, hit: min(8, l - 0.4 * passes + 0.85 * hit),
        hint=0,
    ),
    slip(
        "clamped only at the bottom: walls need a limit too, at L_MAX",
        lambda l, passes, hit: max(-8, l - 0.4 * passes + 0.85 * hit),
        hint=0,
    ),
    slip(
        "hits and passes have changed places: L_FREE is for passed cells, L_OCC for the hit",
        lambda l, passes, hit: clamp(l + 0.85 * passes - 0.4 * hit),
        hint=1,
    ),
    slip(
        "each passed cell counted once a beam: the list names a cell "
        "once for each half-cell step, and each is evidence",
        lambda l, passes, hit: clamp(l - 0.4 * (passes > 0) + 0.85 * hit),
        hint=1,
    ),
    slip(
        "the hits are never added: the second thing a beam says is where it ended",
        lambda l, passes, hit: clamp(l - 0.4 * passes),
        hint=1,
    ),
    slip(
        "the passes are never added: go through the list of passed cells as well",
        lambda l, passes, hit: clamp(l + 0.85 * hit),
        hint=1,
    ),
    slip(
        "the evidence took the place of what was there: add "
        "it, with += or log_odds[cell] + evidence",
        lambda l, passes, hit: 0.85 if hit else -0.4 if passes else l,
        hint=0,
    ),
    slip(
        "p added instead of log odds: 0.7 and 0.4 are "
        "probabilities, L_OCC and L_FREE are their log odds",
        lambda l, passes, hit: clamp(l + 0.4 * passes + 0.7 * hit),
        hint=1,
    ),
    slip(
        "those are probabilities: the chart should show the log odds as they are in the list",
        right,
        lambda l: 1 / (1 + exp(-l)),
        hint=2,
    ),
    slip("x and y look swapped: cell_at() wants x first", right, turned=True, hint=2),
]


def lines_follow(task, world, seed):
    run = task.run(world, seed=seed, seconds=30, mistakes=SLIPS)
    for name, place in CELLS.items():
        run.line(name).follows(run.evidence_at(*place), within=0.02)
    run.scanned(at_least=50)


@check("The wall of the page, with other noise", hint=1)
def same_wall(task):
    lines_follow(task, "wall-ahead", 11)


@check("A wall that stands nearer", hint=2)
def nearer(task):
    lines_follow(task, "nearer-wall", 12)


@check("A gap in the wall", hint=2)
def gap(task):
    lines_follow(task, "wall-with-gap", 13)
