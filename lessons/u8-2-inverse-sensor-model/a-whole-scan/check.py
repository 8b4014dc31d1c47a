"""The layers "free" and "hit": what all the beams of a run say, each cell of 5 cm."""

from grader import check
from mapping.beam import clear_length, end_of_hit, passed_by_steps
from mapping.grid import Grid

GRID = Grid(5)


def says(run, seen_as=lambda x, y, heading, angle: (x, y, heading + angle), only=slice(None)):
    """(free, hit), sets of places in the list, of this run's own scans.

    seen_as  where a beam begins and which way it goes, as a slip would take it
    only     which of the looks count
    """
    free, hit = set(), set()
    for scan in run.scans[only]:
        for angle, reading in scan.beams:
            x, y, direction = seen_as(scan.x, scan.y, scan.heading, angle)
            cells = passed_by_steps(x, y, direction, clear_length(reading, 5), 5)
            free |= {GRID.index(cell) for cell in cells if GRID.holds(cell)}
            end = end_of_hit(x, y, direction, reading)
            hit |= {GRID.index_at(*end)} if end else set()
    hit.discard(None)
    return free - hit, hit


def drawn(run):
    """(free, hit) as the program has drawn them."""
    return tuple({GRID.index_at(x, y) for x, y in run.layer(name)} for name in ("free", "hit"))


def looks_like(run, ought):
    """Whether the cells drawn are these, or nearly."""
    is_drawn = drawn(run)
    different = sum(len(a ^ b) for a, b in zip(is_drawn, ought, strict=True))
    return different <= 0.15 * sum(map(len, ought))


ONE_READING = "only one reading a look is used: go through all of scan()"
SLIPS = [
    (ONE_READING, lambda run: all(len(scan.beams) == 1 for scan in run.scans), 0),
    ("no hit is kept: add it to hits, unless it is None", lambda run: not drawn(run)[1], 2),
    ("no free cell is kept: free.update(passed) adds them all", lambda run: not drawn(run)[0], 2),
    (
        "the robot's heading was left out: angles of scan() are from straight ahead, so add "
        "heading()",
        lambda run: looks_like(run, says(run, lambda x, y, heading, angle: (x, y, angle))),
        1,
    ),
    (
        "the angle was subtracted: both turn clockwise, so add it to heading()",
        lambda run: looks_like(
            run, says(run, lambda x, y, heading, angle: (x, y, heading - angle))
        ),
        1,
    ),
    (
        "all eight beams were sent straight ahead: add the angle of each to heading()",
        lambda run: looks_like(run, says(run, lambda x, y, heading, angle: (x, y, heading))),
        1,
    ),
    (
        "every beam begins where the robot started: ask position() at each look, and add START",
        lambda run: looks_like(
            run, says(run, lambda x, y, heading, angle: (run.start.x, run.start.y, heading + angle))
        ),
        1,
    ),
    (
        "START was not added: position() counts from where the robot started",
        lambda run: looks_like(
            run,
            says(
                run,
                lambda x, y, heading, angle: (x - run.start.x, y - run.start.y, heading + angle),
            ),
        ),
        1,
    ),
    (
        "only the last look is drawn: add to free and hits, don't begin them anew",
        lambda run: looks_like(run, says(run, only=slice(-1, None))),
        2,
    ),
    (ONE_READING, lambda run: sum(map(len, drawn(run))) < 0.4 * sum(map(len, says(run))), 0),
]


def compare(task, world):
    run = task.run(world, seed=5, seconds=90, mistakes=SLIPS)
    run.scanned(at_least=18)
    ought, is_drawn = says(run), drawn(run)
    for name, right, cells in zip(("free", "hit"), ought, is_drawn, strict=True):
        wrong = sorted((right ^ cells) - {None})
        task.expect(
            # A cell or two may go either way where a beam ends on the line between two.
            len(wrong) <= 3,
            expected=f"{len(right)} cells {name}, as the readings of this run say",
            got=f"{len(right - cells)} of these not drawn, {len(cells - right)} others drawn",
            run=run,
            cells=[GRID.cell(index) for index in wrong],
            cell_cm=5,
        )


@check("The post and the shelf", hint=0)
def post_and_shelf(task):
    compare(task, "post-and-shelf")


@check("Another mat", hint=1)
def another(task):
    compare(task, "three-boxes")


@check("A corridor with a gap in one side", hint=2)
def corridor(task):
    compare(task, "corridor")
