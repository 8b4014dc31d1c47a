"""The layers "free" and "hit": what all the beams of a run say, each cell of 5 cm."""

from grader import calls, check, code, lacks, mistake, operator, reads, stores
from mapping.beam import clear_length, end_of_hit, passed_by_steps
from mapping.grid import Grid

GRID = Grid(5)


def says(run, seen_as=None, only=slice(None), beams=slice(None)):
    """(free, hit), sets of indices in the list, of this run's own scans.

    seen_as  (scan, angle, reading) -> x, y, direction, reading as a mistake would take them
    only     which of the scans count
    beams    which beams of each scan count
    """
    free, hit = set(), set()
    for scan in run.scans[only]:
        for angle, reading in scan.beams[beams]:
            beam = scan.x, scan.y, scan.heading + angle, reading
            if seen_as is not None:
                beam = seen_as(scan, angle, reading)
            x, y, direction, length = beam
            cells = passed_by_steps(x, y, direction, clear_length(max(0, length), 5), 5)
            free |= {GRID.index(cell) for cell in cells if GRID.holds(cell)}
            end = end_of_hit(x, y, direction, length)
            hit |= {GRID.index_at(*end)} if end else set()
    hit.discard(None)
    return free - hit, hit


def drawn(run):
    """(free, hit) as the program has drawn them."""
    return tuple({GRID.index_at(x, y) for x, y in run.layer(name)} for name in ("free", "hit"))


def looks_like(run, ought, most=0.15):
    """Whether the cells drawn are these, but for so large a share."""
    is_drawn = drawn(run)
    different = sum(len(a ^ b) for a, b in zip(is_drawn, ought, strict=True))
    return different <= most * sum(map(len, ought))


def seen(x=None, y=None, direction=None, reading=None, most=0.04):
    """A mistake that takes one part of a beam otherwise: (run, scan, angle, reading) -> it.

    Beams straight up the mat run along the line between two columns, where a cell more or less
    hangs on the last digit; `most` leaves room for them.
    """

    def explains(run):
        def beam(scan, angle, length):
            right = scan.x, scan.y, scan.heading + angle, length
            changed = x, y, direction, reading
            return tuple(
                part if change is None else change(run, scan, angle, length)
                for part, change in zip(right, changed, strict=True)
            )

        return looks_like(run, says(run, beam), most)

    return explains


def free_replaced(run):
    """Free cells of the last beam alone, and all the hits."""
    scans = [scan for scan in run.scans if scan.beams]
    last = says(run, only=slice(len(run.scans) - 1, None), beams=slice(-1, None))[0]
    hits = says(run)[1]
    return bool(scans) and looks_like(run, (last - hits, hits))


def measured_again(run):
    """Whether distance() was asked between the scans, once for each beam or so."""
    single = sum(len(scan.beams) == 1 for scan in run.scans)
    return 0 < len(run.scans) - single < single


MISTAKES = [
    mistake(
        "None got into hits: where a beam found nothing, hit is None, so ask before you add it",
        lambda run: "NoneType" in run.error,
        2,
        where=(code("hits.add(_)"), lacks(code("_ is not None", "_ is None", "_ != None"))),
        broken_off=True,
    ),
    mistake(
        "hits.update(hit) takes the cell apart into two numbers: hits.add(hit) keeps it as one",
        lambda run: "'int'" in run.error or " int object" in run.error,
        2,
        where=code("hits.update(_)"),
        broken_off=True,
    ),
    mistake(
        "odometry() is what the robot believes, and it drifts: position() says where it is",
        lambda run: True,
        0,
        where=(calls("odometry"), lacks(calls("position"))),
    ),
    (
        "only one reading is used each time: go through all the pairs of scan()",
        lambda run: all(len(scan.beams) == 1 for scan in run.scans),
        0,
    ),
    mistake(
        "distance() measures anew, straight ahead: take the reading that scan() gives together "
        "with the angle",
        measured_again,
        2,
        where=calls("distance"),
    ),
    ("no hit is kept: add it to hits, unless it is None", lambda run: not drawn(run)[1], 2),
    ("no free cell is kept: free.update(passed) adds them all", lambda run: not drawn(run)[0], 2),
    (
        "only the last pair of each scan is used: the lines that add belong inside the loop",
        lambda run: looks_like(run, says(run, beams=slice(-1, None))),
        2,
    ),
    (
        "only one pair of each scan is used: go through all of them with a loop",
        lambda run: any(
            looks_like(run, says(run, beams=slice(beam, beam + 1)), most=0.15) for beam in range(8)
        ),
        0,
    ),
    mistake(
        "free holds the cells of one beam only: add with free.update(passed), for = throws the "
        "others away",
        free_replaced,
        2,
        where=stores("free"),
    ),
    (
        "only the last scan is drawn: add to free and hits, don't begin them anew",
        lambda run: looks_like(run, says(run, only=slice(-1, None))),
        2,
    ),
    (
        "the robot's heading was left out: the angles of scan() are from straight ahead, so add "
        "heading()",
        seen(direction=lambda run, scan, angle, reading: angle, most=0.15),
        1,
    ),
    mistake(
        "heading() was added twice: the direction is heading() + angle",
        seen(direction=lambda run, scan, angle, reading: 2 * scan.heading + angle),
        1,
        where=calls("heading"),
    ),
    mistake(
        "the angle was subtracted: both turn clockwise, so add it to heading()",
        seen(direction=lambda run, scan, angle, reading: scan.heading - angle),
        1,
        where=operator("-"),
    ),
    (
        "all eight beams were sent straight ahead: add the angle of each to heading()",
        seen(direction=lambda run, scan, angle, reading: scan.heading, most=0.15),
        1,
    ),
    (
        "angle and reading are the wrong way round: scan() gives (angle, reading)",
        seen(
            direction=lambda run, scan, angle, reading: scan.heading + reading,
            reading=lambda run, scan, angle, reading: angle,
        ),
        0,
    ),
    (
        "every beam begins where the robot started: ask position() each time, and add START",
        seen(
            x=lambda run, scan, angle, reading: run.start.x,
            y=lambda run, scan, angle, reading: run.start.y,
        ),
        1,
    ),
    mistake(
        "START was not added: position() counts from where the robot started",
        seen(
            x=lambda run, scan, angle, reading: scan.x - run.start.x,
            y=lambda run, scan, angle, reading: scan.y - run.start.y,
        ),
        1,
        where=lacks(reads("START")),
    ),
    mistake(
        "position() was subtracted: the robot is at START plus what position() says",
        seen(
            x=lambda run, scan, angle, reading: 2 * run.start.x - scan.x,
            y=lambda run, scan, angle, reading: 2 * run.start.y - scan.y,
        ),
        1,
        where=(calls("position"), operator("-")),
    ),
    (
        "x and y are the wrong way round: position() gives x first",
        seen(
            x=lambda run, scan, angle, reading: scan.y,
            y=lambda run, scan, angle, reading: scan.x,
        ),
        1,
    ),
]


def compare(task, world):
    run = task.run(world, seed=5, seconds=90, mistakes=MISTAKES)
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
