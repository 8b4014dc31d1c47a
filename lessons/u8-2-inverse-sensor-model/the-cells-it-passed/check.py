"""cells_passed(x, y, angle, reading): the cells that a beam passed, by half-cell steps.

The robot faces 20 degrees meanwhile, so that a heading which is added to the angle shows.
"""

from math import ceil, degrees, floor

from bugbot.frames import cell_of
from grader import calls, check, code, function, lacks, loops, mistake, number, operator, reads
from mapping.beam import end_of_beam

CELL = 5


def walked(x, y, angle, reading, step=CELL / 2, first=0, short=CELL, cell=CELL, steps=None):
    """The cell, or None, at each step from the step `first`, up to `short` cm before the hit."""
    count = max(0, ceil((reading - short) / step)) if steps is None else steps
    return [cell_of(*end_of_beam(x, y, angle, i * step), cell) for i in range(first, count)]


def passed(*asked, **otherwise):
    """The cells on the mat of a walk."""
    return [each for each in walked(*asked, **otherwise) if each is not None]


def key(cell):
    return tuple(cell) if isinstance(cell, list | tuple) else cell


def same_cells(expected, got):
    """The same cells, in any order; one may well be named more than once."""
    try:
        return {key(cell) for cell in expected} == {key(cell) for cell in got}
    except TypeError:
        return False


def beam(random):
    """A slanting beam, from near the middle of the mat."""
    x, y = (round(random.uniform(90, 110), 1) for _ in range(2))
    return x, y, round(random.uniform(0, 360), 1), round(random.uniform(30, 90), 1)


def with_other(**otherwise):
    """What a mistake answers that walks otherwise."""
    return lambda *asked: passed(*asked, **otherwise)


def along(direction):
    """What a mistake answers that walks in another direction."""
    return lambda x, y, angle, reading: passed(x, y, direction(angle), reading)


def at(end, steps=None):
    """What a mistake answers that names the cell so far along the beam, and no other."""

    def answer(x, y, angle, reading):
        count = len(walked(x, y, angle, reading)) if steps is None else steps
        cell = cell_of(*end_of_beam(x, y, angle, end(reading)), CELL)
        return [] if cell is None else [cell] * count

    return answer


def counted(count):
    """What a mistake answers that takes so many steps: `count` of the steps in the length."""

    def answer(x, y, angle, reading):
        steps = max(0, count((reading - CELL) / (CELL / 2)))
        return passed(x, y, angle, reading, steps=steps)

    return answer


def without(cells, left_out):
    return [cell for cell in cells if cell not in left_out]


def pushed_in(*asked):
    cells = [floor_of(*end_of_beam(*asked[:3], i * CELL / 2)) for i in range(len(walked(*asked)))]
    return [tuple(min(max(each, 0), 39) for each in cell) for cell in cells]


def floor_of(x, y):
    return floor(x / CELL), floor(y / CELL)


def points(x, y, angle, reading):
    steps = range(max(0, ceil((reading - CELL) / (CELL / 2))))
    return [end_of_beam(x, y, angle, i * CELL / 2) for i in steps]


def only_the_end(x, y, angle, reading):
    """One cell, whatever it is: None beyond the mat."""
    return [cell_of(*end_of_beam(x, y, angle, reading - CELL), CELL)]


def without_star(x, y, angle, reading):
    """The point goes to cell_of in one piece."""
    if reading > CELL:
        raise TypeError("cell_of() missing 1 required positional argument: 'y'")
    return []


LAST_MISSING = (
    "the last step is missing: every step that is less than reading - CELL from the start counts"
)
ONE_CENTIMETRE = "steps of 1 cm find cells that the beam hardly touches: step half a cell, CELL / 2"

cells_passed = function(
    "cells_passed(x, y, angle, reading)",
    passed,
    compare=same_cells,
    cell_cm=CELL,
    mistakes=[
        mistake(
            "a star is missing: cell_of wants x and y, and end_of_beam gives both in one; "
            "cell_of(*end_of_beam(...)) takes them apart",
            without_star,
            2,
            where=code("cell_of(end_of_beam(_, _, _, _))"),
        ),
        mistake(
            "only one cell of the beam came out: walk along it, and append the cell at each step",
            only_the_end,
            0,
            where=lacks(loops()),
        ),
        mistake(
            "only the first step came out: the walk must go on, and the return comes after the "
            "loop",
            lambda *asked: passed(*asked)[:1],
            2,
            where=loops(),
        ),
        mistake(
            "the same cell came out at each step: ask end_of_beam for the point `along` cm away, "
            "not for the end of the beam",
            at(lambda reading: reading),
            0,
            where=calls("end_of_beam"),
        ),
        (
            "steps of a whole cell jump over corners: step half a cell, CELL / 2",
            with_other(step=CELL),
            1,
        ),
        mistake(
            "a step is CELL / 2, which is 2.5 cm: CELL // 2 is only 2",
            with_other(step=CELL // 2),
            1,
            where=operator("//"),
        ),
        (ONE_CENTIMETRE, with_other(step=1), 1),
        (
            ONE_CENTIMETRE,
            lambda x, y, angle, reading: passed(
                x, y, angle, reading, step=1, steps=max(0, int(reading - CELL))
            ),
            1,
        ),
        mistake(
            LAST_MISSING + ", so count them with math.ceil(), not int()",
            counted(int),
            1,
            where=calls("int"),
        ),
        (LAST_MISSING, counted(floor), 1),
        (
            "one step too far: a step at exactly reading - CELL does not count, only those that "
            "are less (< and not <=)",
            counted(lambda steps: floor(steps) + 1),
            1,
        ),
        *(
            mistake(
                "the reading was rounded: work with it as it came in",
                lambda x, y, angle, reading, whole=whole: passed(x, y, angle, whole(reading)),
                1,
                where=calls(call),
            )
            for call, whole in (("round", round), ("int", int))
        ),
        (
            "the walk goes right up to the hit, and leaves out the cell there: stop at "
            "reading - CELL, whatever the cell",
            lambda *asked: without(passed(*asked, short=0), at(lambda reading: reading, 1)(*asked)),
            1,
        ),
        (
            "the last cell was taken off: where the walk stops one cell short, all its cells count",
            lambda *asked: without(passed(*asked), passed(*asked)[-1:]),
            1,
        ),
        (
            "something closer than one cell: the list stays empty, so ask how far it is before "
            "the robot's own cell is added",
            lambda *asked: passed(*asked, steps=max(1, len(walked(*asked)))),
            1,
        ),
        (
            "cells beyond the mat were pushed back to its edge: leave them out instead",
            pushed_in,
            2,
        ),
        (
            "walked too far, right up to the hit: stop one cell short of it, at reading - CELL",
            with_other(short=0),
            1,
        ),
        (
            "walked half a cell too far: stop one complete cell short of the hit, at "
            "reading - CELL",
            with_other(short=CELL / 2),
            1,
        ),
        (
            "stopped too early: stop one cell short of the hit, not two",
            with_other(short=2 * CELL),
            1,
        ),
        (
            "the cell of the hit was appended as well: only cells that the beam passed belong in "
            "the list",
            lambda x, y, angle, reading: (
                passed(x, y, angle, reading) + at(lambda reading: reading, 1)(x, y, angle, reading)
            ),
            1,
        ),
        (
            "the cell where the beam begins is missing: the first step is at 0 cm",
            with_other(first=1),
            2,
        ),
        mistake(
            "something closer than one cell: reading - CELL is negative there, and the list "
            "stays empty; don't take abs() of it",
            lambda x, y, angle, reading: passed(x, y, angle, CELL + abs(reading - CELL)),
            1,
            where=calls("abs"),
        ),
        (
            "the beam went straight up: its angle decides the direction, so use end_of_beam",
            along(lambda angle: 0),
            0,
        ),
        mistake(
            "sine and cosine are the wrong way round: end_of_beam has them right, so call it",
            along(lambda angle: 90 - angle),
            0,
            where=(calls("sin"), calls("cos")),
        ),
        mistake(
            "degrees were taken for radians: end_of_beam takes degrees, so call it",
            along(degrees),
            0,
            where=calls("sin", "cos", "exp", "rect"),
        ),
        mistake(
            "heading() was added: the angle is the direction on the mat already",
            along(lambda angle: angle + 20),
            0,
            where=calls("heading"),
        ),
        mistake(
            "the beam begins at START here: it begins at the x and y that the function is given",
            lambda x, y, angle, reading: passed(100, 40, angle, reading),
            0,
            where=reads("START"),
        ),
        ("None is not a cell: where cell_of gives None, append nothing", walked, 2),
        (
            "those are points in cm: ask cell_of for the cell of each",
            points,
            0,
        ),
        (
            "column and row are the wrong way round: a cell is (column, row)",
            lambda *asked: [(row, column) for column, row in passed(*asked)],
            0,
        ),
        (
            "extend() takes a cell apart into two numbers: append() keeps it as one cell",
            lambda *asked: [number for cell in passed(*asked) for number in cell],
            2,
        ),
    ],
)

CELLS_OF_10 = function(
    "cells_passed(x, y, angle, reading)",
    with_other(step=5, short=10, cell=10),
    compare=same_cells,
    cell_cm=10,
    mistakes=[
        mistake(
            "2.5 is typed in as the step: use CELL / 2, so that CELL can change",
            with_other(step=2.5, short=10, cell=10),
            1,
            where=number(2.5),
        ),
        mistake(
            "5 is typed in as the side of a cell: use CELL, so that it can change",
            with_other(step=5, short=5, cell=10),
            1,
            where=number(5),
        ),
        mistake(
            "5 is typed in as the side of a cell: use CELL, so that it can change",
            with_other(step=2.5, short=5, cell=10),
            1,
            where=number(5),
        ),
    ],
)


def ask(task, *asked, **gives):
    task.call(cells_passed, *asked, **gives, world="wall-askew")


@check("A beam straight up the mat", hint=0)
def up(task):
    ask(task, 102.5, 42.5, 0, 46.5, gives=[(20, row) for row in range(8, 17)])
    ask(task, 102.5, 42.5, 0, 48, gives=[(20, row) for row in range(8, 18)])
    ask(task, 102.5, 41, 0, 45, gives=[(20, row) for row in range(8, 16)])
    ask(task, 102.5, 41, 0, 44.8, gives=[(20, row) for row in range(8, 16)])
    ask(task, 102.5, 41, 0, 45.3, gives=[(20, row) for row in range(8, 17)])


@check("A beam to the right", hint=0)
def to_the_right(task):
    ask(task, 52.5, 12.5, 90, 31.5, gives=[(column, 2) for column in range(10, 16)])


@check("Slanting beams", hint=1)
def slanting(task):
    for _ in range(12):
        ask(task, *beam(task.random))


@check("Something very close", hint=2)
def close(task):
    ask(task, 102.5, 42.5, 0, 4, gives=[])
    ask(task, 102.5, 42.5, 70, 0.5, gives=[])
    ask(task, 102.5, 44, 0, 0.2, gives=[])


@check("A beam that leaves the mat, which noise or a wrong pose can cause", hint=2)
def beyond(task):
    ask(task, 172.5, 182.5, 40, 60.7)
    ask(task, 2.5, 52.5, 200, 50.3)
    ask(task, 22.5, 7.5, 170, 40.3)


@check("Cells of 10 cm", hint=2)
def another_size(task):
    task.set("CELL", 10)
    task.set("ACROSS", 20)
    up = [(10, row) for row in range(4, 9)]
    task.call(CELLS_OF_10, 105, 45, 0, 53, gives=up, world="wall-askew")
    task.call(CELLS_OF_10, 105, 45, 29, 83, world="wall-askew")
