"""gap(x, y, real) and wrong_percent(occupied, real): a map held against the truth."""

from math import floor, hypot

from grader import calls, check, function, mistake, near, number, operator
from mapping.score import gap_cm


def nearest_edge(x, y):
    return min(x, 200 - x, y, 200 - y)


def gap_by(edge=nearest_edge, beside=None, joined=hypot, every=min):
    """The distance to the nearest real thing, or a slip of it."""

    def ways(low, length, at):
        return max(low - at, 0, at - (low + length))

    apart = beside or ways

    def gap(x, y, real):
        things = [joined(apart(a, w, x), apart(b, h, y)) for a, b, w, h in real]
        return every([edge(x, y), *things])

    return gap


def edge_if_alone(x, y, real):
    return gap_by(edge=lambda x, y: 1000)(x, y, real) if real else nearest_edge(x, y)


def to_corners(x, y, real):
    """The gap, with the nearest corner of each thing in place of its nearest side."""
    to_corner = gap_by(beside=lambda low, length, at: min(abs(at - low), abs(at - low - length)))
    return to_corner(x, y, real) if gap_cm(x, y, real) else 0


def of_sizes(size):
    """The gap to things whose width and height are mistaken for others."""
    return lambda x, y, real: gap_cm(x, y, [(a, b, *size(w, h)) for a, b, w, h in real])


def percent_by(is_wrong=lambda gap: gap > 5, of=len, times=100, answer=float):
    """The share of wrong cells, or a slip of it."""

    def wrong_percent(occupied, real):
        wrong = [point for point in occupied if is_wrong(gap_cm(*point, real))]
        return answer(times * len(wrong) / of(occupied)) if occupied else 0

    return wrong_percent


gap = function(
    "gap(x, y, real)",
    gap_cm,
    compare=near(0.01, "cm"),
    leaves=True,
    mistakes=[
        *(
            (
                "the walls round the mat are real too: "
                "the gap is never more than to the nearest edge",
                gap_by(edge=lambda x, y, start=start: start),
                0,
            )
            for start in (1000, 9999, float("inf"))
        ),
        (
            "among things the walls round the mat are forgotten: they are always there",
            edge_if_alone,
            0,
        ),
        (
            "the mat has four walls: the gaps to the others are MAT - x and MAT - y",
            gap_by(edge=min),
            0,
        ),
        (
            "the last two numbers of a thing are its width and its height: "
            "it ends at left + width and at bottom + height",
            gap_by(beside=lambda low, high, at: max(low - at, 0, at - high)),
            1,
        ),
        (
            "a thing ends at bottom + height along y: bottom + width is something else",
            of_sizes(lambda w, h: (w, w)),
            1,
        ),
        (
            "width and height are swapped: a thing is (left, bottom, width, height)",
            of_sizes(lambda w, h: (h, w)),
            1,
        ),
        (
            "the nearest corner was taken: beside a thing its side is nearer",
            to_corners,
            1,
        ),
        (
            "that is the distance to the middle of a thing: it begins at its side",
            gap_by(beside=lambda low, length, at: at - (low + length / 2)),
            0,
        ),
        (
            "beside a thing only one of the two distances counts: the other is 0, never less",
            gap_by(beside=lambda low, length, at: max(low - at, at - (low + length))),
            1,
        ),
        (
            "the straight way to a corner is shorter than along both sides: math.hypot(dx, dy)",
            gap_by(joined=lambda dx, dy: dx + dy),
            1,
        ),
        (
            "the straight way to a corner is longer than the larger of the two: math.hypot(dx, dy)",
            gap_by(joined=max),
            1,
        ),
        (
            "only the last thing in the list counts: keep the smallest gap of all",
            gap_by(every=lambda ways: min(ways[0], ways[-1])),
            0,
        ),
    ],
)

wrong_percent = function(
    "wrong_percent(occupied, real)",
    percent_by(),
    compare=near(0.01, "%"),
    leaves=True,
    mistakes=[
        (
            "a cell exactly one cell away is still right: wrong is more than CELL",
            percent_by(lambda gap: gap >= 5),
            2,
        ),
        (
            "that is the share of the right ones: count those further away than CELL",
            percent_by(lambda gap: gap <= 5),
            2,
        ),
        (
            "the share is of the black cells, not of all cells of the mat",
            percent_by(of=lambda cells: 1600),
            2,
        ),
        (
            "a map without black cells: there is nothing to divide by, and nothing wrong",
            lambda occupied, real: percent_by()(occupied, real) if occupied else 1 / 0,
            2,
        ),
        (
            "that is a share from 0 to 1: per cent are a hundred times as many",
            percent_by(times=1),
            2,
        ),
        mistake(
            "// leaves out what comes after the point: / divides and keeps it",
            percent_by(answer=floor),
            2,
            where=operator("//"),
        ),
        mistake(
            "int() leaves out what comes after the point: return the per cent as it is",
            percent_by(answer=int),
            2,
            where=calls("int"),
        ),
        *(
            mistake(
                "the per cent was rounded: return it as it is, and round only what you print",
                percent_by(answer=lambda percent, digits=digits: round(percent, digits)),
                2,
                where=calls("round"),
            )
            for digits in (0, 1)
        ),
    ],
)

OTHER_CELL = 12
in_other_cells = function(
    "wrong_percent(occupied, real)",
    percent_by(lambda gap: gap > OTHER_CELL),
    compare=near(0.01, "%"),
    leaves=True,
    mistakes=[
        mistake(
            "the size of a cell was typed in as a number: use CELL, because the check changes it",
            percent_by(),
            2,
            where=number(5),
        ),
    ],
)

BOX = [100, 100, 20, 10]
POST = [40, 150, 8, 30]


@check("The gap on an empty mat", hint=0)
def empty(task):
    task.call(gap, 30, 90, [], gives=30)
    task.call(gap, 120, 185, [], gives=15)


@check("Beside, above and inside a box", hint=1)
def beside(task):
    task.call(gap, 90, 105, [BOX], gives=10)
    task.call(gap, 110, 118, [BOX], gives=8)
    task.call(gap, 110, 105, [BOX], gives=0)
    task.call(gap, 97, 96, [BOX], gives=5)


@check("Many places among two things", hint=1)
def many(task):
    for _ in range(20):
        x, y = task.random.uniform(30, 170), task.random.uniform(30, 170)
        task.call(gap, x, y, [BOX, POST])


@check("The share of wrong cells", hint=2)
def share(task):
    # The second is 2.5 cm from the box, the last exactly 5 cm from its side.
    cells = [(50.0, 100.0), (97.5, 102.5), (110.0, 95.0), (95.0, 105.0)]
    task.call(wrong_percent, cells, [BOX], gives=25)
    task.call(wrong_percent, [(2.5, 102.5), (7.5, 102.5), (102.5, 52.5)], [BOX])


@check("A map without black cells", hint=2)
def none(task):
    task.call(wrong_percent, [], [BOX], gives=0)


@check("Larger cells", hint=2)
def larger(task):
    task.set("CELL", OTHER_CELL)
    # 4, 10, 14 and 30 cm from the box.
    cells = [(96.0, 105.0), (110.0, 90.0), (110.0, 124.0), (150.0, 105.0)]
    task.call(in_other_cells, cells, [BOX], gives=50)
