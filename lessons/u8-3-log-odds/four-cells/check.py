"""The chart's four series, scan by scan, held against what the readings say."""

from dataclasses import dataclass
from math import ceil, exp, floor

from grader import calls, check, code, function, lacks
from grader import mistake as cause
from mapping.beam import clear_length, end_of_hit, passed_by_steps
from mapping.grid import Grid

CELLS = {
    "floor": (102.5, 122.5),
    "in front": (102.5, 147.5),
    "wall": (102.5, 152.5),
    "behind": (102.5, 177.5),
}
GRID = Grid(5)


def clamp(l):
    return max(-8, min(8, l))


@dataclass(frozen=True)
class Beam:
    """What one beam says about one cell."""

    passes: int
    """How often it names the cell as passed."""
    hit: bool
    steps: int
    """How many names of passed cells there are altogether."""


def beams_at(run, x, y):
    """For each scan, what its beams say about the cell of a point."""
    cell = floor(x / 5), floor(y / 5)
    for scan in run.scans:
        said = []
        for angle, reading in scan.beams:
            beam = (scan.x, scan.y, scan.heading + angle)
            passed = passed_by_steps(*beam, clear_length(reading, 5), 5)
            on_the_mat = [each for each in passed if GRID.holds(each)]
            end = end_of_hit(*beam, reading)
            hit = end is not None and (floor(end[0] / 5), floor(end[1] / 5)) == cell
            said.append(Beam(on_the_mat.count(cell), hit, len(on_the_mat)))
        yield said


def retold(run, x, y, rule, shown):
    """The cell's series if every beam changed its log odds by `rule(l, beam)`."""
    l = 0.0
    for said in beams_at(run, x, y):
        for beam in said:
            l = rule(l, beam)
        yield shown(l)


def mistake(said, rule, shown=lambda l: l, hint=None, turned=False):
    """A mistake, by what it makes of the four series."""

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


def right(l, beam):
    return clamp(l - 0.4 * beam.passes + 0.85 * beam.hit)


def beam_by_beam(l, beam, added):
    for weight in beam.passes * [-0.4] + beam.hit * [0.85]:
        l = added(l, weight)
    return l


def hit_at_each_step(l, beam):
    for step in range(beam.steps):
        l = clamp(l - 0.4 * (step < beam.passes))
        l = clamp(l + 0.85 * beam.hit)
    return l


def plots_cells(run):
    """Whether each series is the number of its cell."""
    return all(
        value == GRID.index_at(x, y)
        for name, (x, y) in CELLS.items()
        for _, value in run.line(name).points
    )


MISTAKES = [
    cause(
        "where a beam found nothing, hit is None: ask before you add L_OCC",
        lambda run: "NoneType" in run.error,
        1,
        where=lacks(code("_ is not None", "_ is None", "_ != None", "_ == None")),
        broken_off=True,
    ),
    (
        "the log odds stay at 0: store what comes out back into the list, log_odds[cell] = ...",
        lambda run: all(value == 0 for name in CELLS for _, value in run.line(name).points),
        0,
    ),
    mistake(
        "there is no clamp: add(), after adding, must keep log_odds[cell] between -L_MAX and L_MAX",
        lambda l, beam: l - 0.4 * beam.passes + 0.85 * beam.hit,
        hint=0,
    ),
    mistake(
        "the clamp comes before the adding: add first, then clamp what comes out",
        lambda l, beam: beam_by_beam(l, beam, lambda l, weight: clamp(l) + weight),
        hint=0,
    ),
    mistake(
        "the hit is not clamped: let add() add the hit too",
        lambda l, beam: beam_by_beam(
            l, beam, lambda l, weight: clamp(l + weight) if weight < 0 else l + weight
        ),
        hint=0,
    ),
    cause(
        "min() and max() have changed places: whatever is added, a limit comes out",
        lambda run: all(
            abs(value) in (0, 8) for name in CELLS for _, value in run.line(name).points
        ),
        0,
        where=(calls("min"), calls("max")),
    ),
    mistake(
        "clamped only at the top: floor needs a limit too, at -L_MAX",
        lambda l, beam: min(8, l - 0.4 * beam.passes + 0.85 * beam.hit),
        hint=0,
    ),
    mistake(
        "clamped only at the bottom: walls need a limit too, at L_MAX",
        lambda l, beam: max(-8, l - 0.4 * beam.passes + 0.85 * beam.hit),
        hint=0,
    ),
    mistake(
        "hits and passes have changed places: L_FREE is for passed cells, L_OCC for the hit",
        lambda l, beam: clamp(l + 0.85 * beam.passes - 0.4 * beam.hit),
        hint=1,
    ),
    mistake(
        "each passed cell counted once a beam: the list names a cell once for each half-cell "
        "step, and each is evidence",
        lambda l, beam: clamp(l - 0.4 * (beam.passes > 0) + 0.85 * beam.hit),
        hint=1,
    ),
    mistake(
        "the hits are never added: the second thing a beam says is where it ended",
        lambda l, beam: clamp(l - 0.4 * beam.passes),
        hint=1,
    ),
    mistake(
        "the passes are never added: go through the list of passed cells as well",
        lambda l, beam: clamp(l + 0.85 * beam.hit),
        hint=1,
    ),
    mistake(
        "the hit was added again for each passed cell: it belongs after the loop, once a beam",
        hit_at_each_step,
        hint=1,
    ),
    mistake(
        "the sign of L_FREE is turned round: it is negative already, so add it as it is",
        lambda l, beam: clamp(l + 0.4 * beam.passes + 0.85 * beam.hit),
        hint=1,
    ),
    mistake(
        "the evidence took the place of what was there: add it, with += or "
        "log_odds[cell] + evidence",
        lambda l, beam: 0.85 if beam.hit else -0.4 if beam.passes else l,
        hint=0,
    ),
    mistake(
        "p was added, not log odds: 0.7 and 0.4 are probabilities, L_OCC and L_FREE are their log "
        "odds",
        lambda l, beam: clamp(l + 0.4 * beam.passes + 0.7 * beam.hit),
        hint=1,
    ),
    mistake(
        "those are probabilities: the chart should show the log odds as they are in the list",
        right,
        lambda l: 1 / (1 + exp(-l)),
        hint=2,
    ),
    mistake("x and y are the wrong way round: cell_at() wants x first", right, turned=True, hint=2),
    (
        "those are the numbers of the cells: plot log_odds[...] of each, not the number itself",
        plots_cells,
        2,
    ),
]


def while_nearer(x, y, angle, length, cell):
    """The cells of the rule in U8.2, `while along < clear`: a last step that is begun counts."""
    return passed_by_steps(x, y, angle, ceil(length / (cell / 2)) * cell / 2, cell)


def lines_follow(task, world, seed):
    run = task.run(world, seed=seed, seconds=30, mistakes=MISTAKES)
    for name, place in CELLS.items():
        run.line(name).follows(
            run.evidence_at(*place),
            within=0.02,
            or_else=run.evidence_at(*place, passed_by=while_nearer),
        )
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


@check("Beams that find nothing", hint=1)
def nothing(task):
    lines_follow(task, "open-corner", 14)


CORNER_BEAM = (12.5, 12.5, 225, 12.5)
"""Down to the left through cells 82 and 41 to cell 0, which no other beam of the run gets near."""

add_beam = function("add_beam(x, y, angle, reading)", lambda *_: None, compare=lambda *_: True)


def same_where_wanted(wanted, got):
    """The same log odds where any are wanted; also for a single cell."""
    if isinstance(wanted, list):
        rows = isinstance(got, list | tuple) and len(got) == len(wanted)
        return rows and all(map(same_where_wanted, wanted, got))
    try:
        return wanted is None or abs(float(got) - wanted) < 0.001
    except (TypeError, ValueError):
        return False


@check("A beam that ends in the corner of the mat", hint=1)
def corner(task):
    task.call(add_beam, *CORNER_BEAM)
    evidence = {0: 0.85, 41: -0.4, 82: -0.8}
    wanted = [evidence.get(cell) for cell in range(1600)]
    task.variable("log_odds", gives=wanted, compare=same_where_wanted)
