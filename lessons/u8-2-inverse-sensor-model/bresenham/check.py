"""line_of_cells(first, last): Bresenham's line. Only lines without a tie are asked for."""

from grader import check, function
from mapping.beam import bresenham


def stepped(first, last, gain=2, over=1, taken_off=lambda drift, longer: drift - 2 * longer):
    """The line by the steps of the lesson, with something changed.

    gain       a step adds so many times the shorter side
    over       the step goes sideways above so many times the longer side
    taken_off  the drift after that
    """
    column, row = first
    wide, high = abs(last[0] - column), abs(last[1] - row)
    right = 1 if last[0] > column else -1
    up = 1 if last[1] > row else -1
    longer, shorter = max(wide, high), min(wide, high)
    cells, drift = [(column, row)], 0
    for _ in range(longer):
        drift += gain * shorter
        sideways = drift > over * longer
        if sideways:
            drift = taken_off(drift, longer)
        if wide >= high or sideways:
            column += right
        if wide < high or sideways:
            row += up
        cells.append((column, row))
    return cells


def with_other(**changed):
    """What a mistake answers that steps otherwise."""
    return lambda first, last: stepped(first, last, **changed)


def rounded_down(first, last):
    """As if the line went sideways only after a complete cell, instead of half a cell."""
    (c0, r0), (c1, r1) = first, last
    wide, high = abs(c1 - c0), abs(r1 - r0)
    right, up, longer = (1 if c1 > c0 else -1), (1 if r1 > r0 else -1), max(wide, high)
    return [
        (c0 + right * (step * wide // (longer or 1)), r0 + up * (step * high // (longer or 1)))
        for step in range(longer + 1)
    ]


def by_columns(first, last):
    """A cell in each column only: right for lines that are not steep."""
    (c0, r0), (c1, r1) = first, last
    wide, right = abs(c1 - c0), 1 if c1 > c0 else -1
    return [first] + [
        (c0 + right * step, r0 + round(step * (r1 - r0) / wide)) for step in range(1, wide + 1)
    ]


def diagonal_first(first, last):
    column, row = first
    cells = [(column, row)]
    while (column, row) != tuple(last):
        column += (last[0] > column) - (last[0] < column)
        row += (last[1] > row) - (last[1] < row)
        cells.append((column, row))
    return cells


def no_diagonals(columns_first):
    """What a mistake answers that puts a cell in at each corner; columns_first(wide, high)."""

    def answer(first, last):
        cells = [tuple(first)]
        sideways_first = columns_first(abs(last[0] - first[0]), abs(last[1] - first[1]))
        for column, row in bresenham(first, last)[1:]:
            before = cells[-1]
            if before[0] != column and before[1] != row:
                cells.append((column, before[1]) if sideways_first else (before[0], row))
            cells.append((column, row))
        return cells

    return answer


def mirrored(right, up):
    """What a mistake answers that only goes right, or only up."""

    def answer(first, last):
        column = first[0] + abs(last[0] - first[0]) if right else last[0]
        row = first[1] + abs(last[1] - first[1]) if up else last[1]
        return bresenham(first, (column, row))

    return answer


def turned(first, last):
    """As if the longer side were taken for the shorter one: a step up where one goes right."""
    (c0, r0), (c1, r1) = first, last
    wide, high = abs(c1 - c0), abs(r1 - r0)
    right, up = (1 if c1 > c0 else -1), (1 if r1 > r0 else -1)
    along = bresenham((0, 0), (high, wide))
    return [(c0 + right * column, r0 + up * row) for column, row in along]


NEVER_DIAGONALLY = (
    "never diagonally: going sideways belongs to the same step, so append one cell a step"
)
BACKWARDS = "the cells come in the wrong order: first comes first, last comes last"

line_of_cells = function(
    "line_of_cells(first, last)",
    bresenham,
    cell_cm=5,
    mistakes=[
        (
            "the last cell is missing: a line of 4 steps has 5 cells",
            lambda first, last: bresenham(first, last)[:-1] or [first],
            0,
        ),
        (
            "the first cell is there twice: it is in cells already, so begin with the first step",
            lambda first, last: [first, *bresenham(first, last)],
            2,
        ),
        (
            "only the two ends came out: append a cell at each step between them",
            lambda first, last: [first, last],
            2,
        ),
        (
            "steep lines have gaps: where a line is higher than wide, go row by row",
            by_columns,
            0,
        ),
        (
            "only lines to the right come out: if last is further left, the columns count down",
            mirrored(right=True, up=False),
            0,
        ),
        (
            "only lines upwards come out: if last is further down, the rows count down",
            mirrored(right=False, up=True),
            0,
        ),
        (
            "only lines to the right and upwards come out: columns and rows may count down as well",
            mirrored(right=True, up=True),
            0,
        ),
        (
            "sideways too late: go sideways once the line is more than half a cell off, not a "
            "complete one",
            rounded_down,
            1,
        ),
        (
            "sideways too late: where a step adds 2 * shorter, half a cell is `longer`, and more "
            "than that goes sideways",
            with_other(gain=1),
            1,
        ),
        (
            "sideways too late: where a step adds 2 * shorter, half a cell is `longer`, and more "
            "than that goes sideways",
            with_other(over=2),
            1,
        ),
        (
            "nothing is taken off the drift after a step sideways: a complete cell, 2 * longer, "
            "has to go",
            with_other(taken_off=lambda drift, longer: drift),
            1,
        ),
        (
            "the drift was set to 0 after a step sideways: take 2 * longer off, so that what is "
            "left over counts on",
            with_other(taken_off=lambda drift, longer: 0),
            1,
        ),
        (
            "too little is taken off the drift after a step sideways: a complete cell is "
            "2 * longer",
            with_other(taken_off=lambda drift, longer: drift - longer),
            1,
        ),
        (
            "first diagonally, then straight: the steps sideways should be spread along the line",
            diagonal_first,
            1,
        ),
        (NEVER_DIAGONALLY, no_diagonals(lambda wide, high: wide >= high), 2),
        (NEVER_DIAGONALLY, no_diagonals(lambda wide, high: True), 2),
        (NEVER_DIAGONALLY, no_diagonals(lambda wide, high: False), 2),
        (
            "wide and high are the wrong way round: a line that is wider than high goes one "
            "column further at each step",
            turned,
            0,
        ),
        (BACKWARDS, lambda first, last: bresenham(first, last)[::-1], 0),
        (BACKWARDS, lambda first, last: sorted(bresenham(first, last)), 0),
        (BACKWARDS, lambda first, last: bresenham(*sorted([first, last])), 0),
    ],
)


@check("Straight lines", hint=0)
def straight(task):
    task.call(line_of_cells, (2, 3), (6, 3), gives=[(2, 3), (3, 3), (4, 3), (5, 3), (6, 3)])
    task.call(line_of_cells, (4, 2), (4, 5), gives=[(4, 2), (4, 3), (4, 4), (4, 5)])


@check("A gentle line", hint=1)
def gentle(task):
    task.call(line_of_cells, (0, 0), (3, 1), gives=[(0, 0), (1, 0), (2, 1), (3, 1)])
    task.call(line_of_cells, (0, 0), (5, 2), gives=[(0, 0), (1, 0), (2, 1), (3, 1), (4, 2), (5, 2)])


@check("A steep line", hint=0)
def steep(task):
    task.call(line_of_cells, (0, 0), (1, 3), gives=[(0, 0), (0, 1), (1, 2), (1, 3)])


@check("A diagonal line", hint=0)
def diagonal(task):
    task.call(line_of_cells, (5, 5), (8, 8), gives=[(5, 5), (6, 6), (7, 7), (8, 8)])


@check("Lines to the left and downwards", hint=0)
def left_and_down(task):
    task.call(line_of_cells, (10, 2), (3, 5))
    task.call(line_of_cells, (4, 10), (1, 3))
    task.call(line_of_cells, (10, 14), (15, 11))
    task.call(line_of_cells, (10, 3), (6, 3))
    task.call(line_of_cells, (2, 10), (2, 7))
    task.call(line_of_cells, (10, 5), (7, 2))


@check("One cell", hint=0)
def one(task):
    task.call(line_of_cells, (7, 7), (7, 7), gives=[(7, 7)])


@check("Many lines", hint=2)
def many(task):
    for _ in range(30):
        longer = task.random.randrange(1, 25, 2)  # odd, so that no cell is a tie
        shorter = task.random.randint(0, longer)
        wide, high = (longer, shorter) if task.random.random() < 0.5 else (shorter, longer)
        wide, high = wide * task.random.choice((-1, 1)), high * task.random.choice((-1, 1))
        column, row = task.random.randrange(24, 30), task.random.randrange(24, 30)
        task.call(line_of_cells, (column, row), (column + wide, row + high))
