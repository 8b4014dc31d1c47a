"""The layers "free" and "hit": what all the beams of a run say, each cell of 5 cm."""

import ast
from itertools import groupby, takewhile
from math import radians

from grader import calls, check, code, either, lacks, mistake, operator, reads, stores
from mapping.beam import clear_length, end_of_hit, passed_by_steps
from mapping.grid import Grid

GRID = Grid(5)


def beam_says(x, y, direction, length):
    """(passed, hit) of a beam: a set of indices in the list, and an index or None."""
    cells = passed_by_steps(x, y, direction, clear_length(max(0, length), 5), 5)
    end = end_of_hit(x, y, direction, length)
    passed = {GRID.index(cell) for cell in cells if GRID.holds(cell)}
    return passed, GRID.index_at(*end) if end else None


def add_all(free, hits, beams):
    """What is right for one scan: `beams` is what each of its beams says."""
    for passed, hit in beams:
        free |= passed
        hits |= {hit} - {None}


def says(run, seen_as=None, only=slice(None), rule=add_all):
    """(free, hit), sets of indices in the list, of this run's own scans.

    seen_as  (scan, angle, reading) -> x, y, direction, reading as a mistake would take them
    only     which of the scans count
    rule     how a mistake adds what the beams of a scan say
    """
    take = seen_as or (lambda scan, angle, reading: (scan.x, scan.y, scan.heading + angle, reading))
    free, hits = set(), set()
    for scan in run.scans[only]:
        rule(free, hits, [beam_says(*take(scan, *beam)) for beam in scan.beams])
    return free - hits, hits


def drawn(run):
    """(free, hit) as the program has drawn them."""
    return tuple({GRID.index_at(x, y) for x, y in run.layer(name)} for name in ("free", "hit"))


def difference(some, others):
    return sum(len(a ^ b) for a, b in zip(some, others, strict=True))


def together(beams):
    free, hits = set(), set()
    add_all(free, hits, beams)
    return free - hits, hits


def by_place_and_angle(run):
    """What the readings of each place and angle say: several, where scan() was asked again.

    A distance() beside a scan may be left out: it stands beside a beam that says nothing.
    """
    for _, group in groupby(run.scans, lambda scan: (scan.x, scan.y, scan.heading)):
        angles, scans = {}, list(group)
        for scan in scans:
            needed = len(scan.beams) > 1 or all(len(each.beams) == 1 for each in scans)
            for angle, reading in scan.beams:
                said = beam_says(scan.x, scan.y, scan.heading + angle, reading)
                angles.setdefault(angle, [] if needed else [(set(), None)]).append(said)
        yield from angles.values()


def ought_to_be(run):
    """(free, hit) of the readings used: one at least of each place and angle."""
    is_drawn = free, hits = drawn(run)
    used, more = [], []
    for said in by_place_and_angle(run):
        first, *rest = sorted(
            said, key=lambda beam: len(beam[0] - free - hits) + len({beam[1]} - hits - {None})
        )
        used.append(first)
        more += rest
    for beam in more:
        if difference(together([*used, beam]), is_drawn) < difference(together(used), is_drawn):
            used.append(beam)
    return together(used)


def mixed(run):
    """Whether the free cells come from some readings, and the hits from others of the same look."""
    free, hits = drawn(run)
    said = list(by_place_and_angle(run))
    return (
        all(len(beams) > 1 for beams in said)
        and not free - set().union(*(passed for beams in said for passed, _ in beams))
        and not hits - {hit for beams in said for _, hit in beams}
        and all(any(passed <= free | hits for passed, _ in beams) for beams in said)
        and all(any(hit is None or hit in hits for _, hit in beams) for beams in said)
    )


def looks_like(run, ought, most=0.15):
    """Whether the cells drawn are these, but for so large a share."""
    return difference(drawn(run), ought) <= most * sum(map(len, ought))


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


def added(*rules, most=0.004):
    """A mistake that adds by one of these rules."""
    return lambda run: any(looks_like(run, says(run, rule=rule), most) for rule in rules)


def of(choice):
    """The rule that adds only such of the beams."""
    return lambda free, hits, beams: add_all(free, hits, choice(beams))


def until_nothing(beams):
    return list(takewhile(lambda beam: beam[1] is not None, beams))


def last_hit_only(free, hits, beams):
    free.update(*(passed for passed, _ in beams))
    hits |= {beams[-1][1]} - {None}


def hits_not_passed(free, hits, beams):
    for passed, hit in beams:
        free |= passed
        hits |= {hit} - {None} - free


def passes_take_hits(free, hits, beams):
    for passed, hit in beams:
        hits -= passed
        add_all(free, hits, [(passed, hit)])


def free_replaced(run):
    """Free cells of the last beam alone, and all the hits."""
    last = says(run, only=slice(-1, None), rule=of(lambda beams: beams[-1:]))[0]
    hits = says(run)[1]
    return bool(run.scans) and looks_like(run, (last - hits, hits))


def measured_again(run):
    """Whether distance() was asked between the scans, once for each beam or so."""
    single = sum(len(scan.beams) == 1 for scan in run.scans)
    return 0 < len(run.scans) - single < single


def own_set(name):
    """Whether such a set is given a value inside a function, without `global`."""

    def stands(text):
        given = {each for n in text.nodes if isinstance(n, ast.Global) for each in n.names}
        stored = (n for n in text.nodes if isinstance(n, ast.Name) and n.id == name)
        inside = any(isinstance(n.ctx, ast.Store) and n.col_offset > 0 for n in stored)
        return inside and name not in given

    return stands


MISTAKES = [
    mistake(
        "None got into hits: hit is None where a beam found nothing or ended beyond the mat, so "
        "ask `if hit is not None` before you add it",
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
        "+ joins START and position() to four numbers: add x to x and y to y",
        lambda run: "unpack" in run.error,
        1,
        where=code("START + position()", "position() + START"),
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
    mistake(
        "look() makes a new set hits, which is gone when it ends: leave that line out",
        lambda run: not drawn(run)[1],
        2,
        where=own_set("hits"),
    ),
    mistake(
        "look() makes a new set free, which is gone when it ends: leave that line out",
        lambda run: not drawn(run)[0],
        2,
        where=own_set("free"),
    ),
    ("no hit is kept: add it to hits, unless it is None", lambda run: not drawn(run)[1], 2),
    ("no free cell is kept: free.update(passed) adds them all", lambda run: not drawn(run)[0], 2),
    (
        "only the last pair of each scan is used: the lines that add belong inside the loop",
        added(of(lambda beams: beams[-1:]), most=0.15),
        2,
    ),
    (
        "only one pair of each scan is used: go through all of them with a loop",
        added(*(of(lambda beams, i=i: beams[i : i + 1]) for i in range(8)), most=0.15),
        0,
    ),
    mistake(
        "one pair of each scan is left out: all eight count, the first and the last too",
        added(of(lambda beams: beams[1:]), of(lambda beams: beams[:-1])),
        0,
        where=either(code("_[1:]", "_[:-1]", "_[:7]"), calls("range")),
    ),
    (
        "the free cells are added only where there is a hit: a beam without one has passed cells "
        "too",
        added(of(lambda beams: [beam for beam in beams if beam[1] is not None])),
        2,
    ),
    (
        "the first beam without a hit ends the loop, and the beams after it are lost: go on with "
        "the next one",
        added(of(until_nothing), of(lambda beams: beams[: len(until_nothing(beams)) + 1])),
        2,
    ),
    (
        "of each scan only the last hit is kept: the line that adds it belongs inside the loop",
        added(last_hit_only),
        2,
    ),
    mistake(
        "a hit is left out where a beam has passed: a cell both passed and hit counts as hit",
        added(hits_not_passed),
        2,
        where=code("_ not in _", "_ in _", "_ - _"),
    ),
    mistake(
        "hits are taken away where a later beam passes: a cell both passed and hit counts as hit",
        added(passes_take_hits),
        2,
        where=either(operator("-"), calls("difference_update", "difference", "discard", "remove")),
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
        "beam_says wants degrees, and turns them into radians itself: give it heading() + angle",
        seen(direction=lambda run, scan, angle, reading: radians(scan.heading + angle), most=0.15),
        1,
        where=calls("radians"),
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
    (
        "scan() was asked more than once in a look, and measures anew each time: keep what it "
        "gives, beams = scan(), and go through that",
        mixed,
        2,
    ),
]


def compare(task, world):
    run = task.run(world, seed=5, seconds=90, mistakes=MISTAKES)
    run.scanned(at_least=18)
    ought, is_drawn = ought_to_be(run), drawn(run)
    for name, right, cells in zip(("free", "hit"), ought, is_drawn, strict=True):
        wrong = sorted((right ^ cells) - {None})
        task.expect(
            # A cell or two may go either way where a beam ends on the line between two.
            len(wrong) <= 3,
            expected=f"{len(right)} cells {name}, as the readings of this run say",
            got=f"{len(right - cells)} of these are missing, and "
            f"{len(cells - right)} others are drawn",
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
