"""add_all(grid, rows, columns, evidence, limit): NumPy adds to many cells at once."""

from grader import (
    calls,
    check,
    code,
    either,
    function,
    in_words,
    loops,
    mistake,
    near,
    number,
    operator,
    reads,
)


def clamped(grid, low, high):
    return [[float(max(low, min(high, l))) for l in row] for row in grid]


def added(grid, rows, columns, evidence):
    out = [list(row) for row in grid]
    for row, column in zip(rows, columns):
        out[row][column] += evidence
    return out


def add_each(grid, rows, columns, evidence, limit):
    return clamped(added(grid, rows, columns, evidence), -limit, limit)


def unclamped(grid, rows, columns, evidence, limit):
    return added(grid, rows, columns, evidence)


def once_each(grid, rows, columns, evidence, limit):
    pairs = sorted(set(zip(rows, columns)))
    return add_each(
        grid, [row for row, _ in pairs], [column for _, column in pairs], evidence, limit
    )


def pairs_of_all(grid, rows, columns, evidence, limit):
    all_rows = [row for row in rows for _ in columns]
    return add_each(grid, all_rows, list(columns) * len(rows), evidence, limit)


def clamped_step_by_step(grid, rows, columns, evidence, limit):
    out = [list(row) for row in grid]
    for row, column in zip(rows, columns):
        out[row][column] = max(-limit, min(limit, out[row][column] + evidence))
    return out


def named_clamped(grid, rows, columns, evidence, limit):
    out = added(grid, rows, columns, evidence)
    for row, column in zip(rows, columns):
        out[row][column] = max(-limit, min(limit, out[row][column]))
    return out


def clamped_first(grid, rows, columns, evidence, limit):
    return added(clamped(grid, -limit, limit), rows, columns, evidence)


def between(low, high):
    """What a mistake answers that clamps between low(limit) and high(limit)."""

    def answer(grid, rows, columns, evidence, limit):
        return clamped(added(grid, rows, columns, evidence), low(limit), high(limit))

    return answer


NO_LIMIT = 1e9


def within(numbers, grid):
    """NumPy's error, if one of the numbers is no row of the grid."""
    for number_of_row in numbers:
        if number_of_row >= len(grid):
            size = f"axis 0 with size {len(grid)}"
            raise IndexError(f"index {number_of_row} is out of bounds for {size}")


def swapped(grid, rows, columns, evidence, limit):
    within(columns, grid)
    return add_each(grid, columns, rows, evidence, limit)


def whole_rows(grid, rows, evidence, limit):
    out = [list(row) for row in grid]
    for row in rows:
        out[row] = [l + evidence for l in out[row]]
    return clamped(out, -limit, limit)


def both_as_rows(grid, rows, columns, evidence, limit):
    within([*rows, *columns], grid)
    return whole_rows(grid, [*rows, *columns], evidence, limit)


def turned_over(*asked):
    return [list(line) for line in zip(*add_each(*asked))]


def breaks_off(error):
    """What a mistake answers that never comes to an answer."""

    def answer(*_):
        raise error

    return answer


def first_apart(expected, got):
    """The first cell that is wrong; None where the answer is no grid of this size."""
    size = [len(line) for line in expected]
    if not isinstance(got, list) or [len(line) for line in got if isinstance(line, list)] != size:
        return None
    cells = [
        (row, column, right, got[row][column])
        for row, line in enumerate(expected)
        for column, right in enumerate(line)
    ]
    if not all(isinstance(wrong, int | float) for *_, wrong in cells):
        return None
    cells = [each for each in cells if abs(each[2] - each[3]) > 0.0001]
    if not cells:
        return None
    row, column, right, wrong = cells[0]
    others = f"; {len(cells)} cells are wrong" if len(cells) > 1 else ""
    return f"{right:g} in row {row}, column {column}", f"{wrong:g} there{others}"


add_all = function(
    "add_all(grid, rows, columns, evidence, limit)",
    add_each,
    compare=in_words(near(0.0001), first_apart),
    mistakes=[
        mistake(
            "a repeated cell counted once: grid[rows, columns] += evidence does that; np.add.at() "
            "counts every one",
            once_each,
            1,
            where=code("_[_] += _", "_[_] = _"),
        ),
        (
            "a cell that is named twice counted once: each time it is named is evidence",
            once_each,
            1,
        ),
        mistake(
            "what comes back is not clamped: np.clip() changes nothing in place, it gives back a "
            "new array",
            unclamped,
            2,
            where=calls("clip"),
        ),
        (
            "what comes back is not clamped: hold it between -limit and limit",
            unclamped,
            2,
        ),
        (
            "row and column are the wrong way round: it is grid[row, column], with the row first",
            swapped,
            0,
        ),
        (
            "a repeated cell counted once, and what comes back is not clamped",
            lambda grid, rows, columns, evidence, limit: once_each(
                grid, rows, columns, evidence, NO_LIMIT
            ),
            1,
        ),
        mistake(
            "it is clamped only at the top: np.minimum() holds one side, np.clip() both",
            between(lambda limit: -NO_LIMIT, lambda limit: limit),
            2,
            where=calls("minimum", "min"),
        ),
        (
            "it is clamped only at the top: free floor needs a limit too, at -limit",
            between(lambda limit: -NO_LIMIT, lambda limit: limit),
            2,
        ),
        mistake(
            "it is clamped only at the bottom: np.maximum() holds one side, np.clip() both",
            between(lambda limit: -limit, lambda limit: NO_LIMIT),
            2,
            where=calls("maximum", "max"),
        ),
        (
            "it is clamped only at the bottom: walls need a limit too, at limit",
            between(lambda limit: -limit, lambda limit: NO_LIMIT),
            2,
        ),
        (
            "the bottom is 0 here: free floor goes below 0, down to -limit",
            between(lambda limit: 0, lambda limit: limit),
            2,
        ),
        mistake(
            "the limit is 8 here, whatever the function is told: use its parameter `limit`",
            between(lambda limit: -8, lambda limit: 8),
            2,
            where=either(number(8), reads("L_MAX")),
        ),
        mistake(
            "-limit and limit have changed places: np.clip(grid, -limit, limit)",
            between(lambda limit: limit, lambda limit: -limit),
            2,
            where=calls("clip"),
        ),
        mistake(
            "-limit and limit have changed places: np.clip(grid, -limit, limit)",
            lambda grid, rows, columns, evidence, limit: [[-limit for _ in row] for row in grid],
            2,
            where=calls("clip"),
        ),
        (
            "clamped before the evidence was added: add first, then clamp",
            clamped_first,
            2,
        ),
        (
            "only the named cells were clamped: in the end the whole grid is",
            named_clamped,
            2,
        ),
        mistake(
            "clamped after each step: add all the evidence first, then clamp the whole grid once",
            clamped_step_by_step,
            2,
            where=loops(),
        ),
        (
            "the evidence went to every cell: only the named ones get it",
            lambda grid, rows, columns, evidence, limit: clamped(
                [[l + evidence for l in row] for row in grid], -limit, limit
            ),
            0,
        ),
        (
            "nothing was added: the named cells get the evidence before the clamp",
            lambda grid, rows, columns, evidence, limit: clamped(grid, -limit, limit),
            1,
        ),
        (
            "1 was added each time: add the evidence",
            lambda grid, rows, columns, evidence, limit: add_each(grid, rows, columns, 1, limit),
            1,
        ),
        (
            "the evidence was subtracted: it has its own sign already, so add it",
            lambda grid, rows, columns, evidence, limit: add_each(
                grid, rows, columns, -evidence, limit
            ),
            1,
        ),
        (
            "each row was joined with each column: the first row goes with the first column only, "
            "the second with the second, and so on",
            pairs_of_all,
            0,
        ),
        mistake(
            "the list of both names whole rows: give NumPy a pair in round brackets, "
            "(rows, columns)",
            both_as_rows,
            2,
            where=code("[rows, columns]"),
        ),
        (
            "the evidence went to whole rows: grid[row] is a row, grid[row, column] a cell",
            lambda grid, rows, columns, evidence, limit: whole_rows(grid, rows, evidence, limit),
            0,
        ),
        mistake(
            "only the first cell got its evidence: a return inside the loop ends the function at "
            "once",
            lambda grid, rows, columns, evidence, limit: add_each(
                grid, rows[:1], columns[:1], evidence, limit
            ),
            1,
            where=loops(),
        ),
        mistake(
            "the last cell that is named got nothing: the loop ends one too soon",
            lambda grid, rows, columns, evidence, limit: add_each(
                grid, rows[:-1], columns[:-1], evidence, limit
            ),
            1,
            where=(loops(), operator("-")),
        ),
        (
            "rows and columns are swapped in the answer: leave out what swaps them",
            turned_over,
            0,
        ),
        mistake(
            "np.add.at() changes the grid itself and gives back None: leave out the `grid =` "
            "before it",
            breaks_off(TypeError("'>=' not supported between instances of 'NoneType' and 'int'")),
            2,
            where=code("_ = np.add.at(_, _, _)"),
        ),
        mistake(
            "np.add.at() wants rows and columns as one pair: (rows, columns) in brackets",
            breaks_off(TypeError("at() takes at most 3 arguments (4 given)")),
            2,
            where=code("np.add.at(_, _, _, _)"),
        ),
    ],
)

EMPTY = [[0, 0, 0], [0, 0, 0], [0, 0, 0]]


@check("One cell", hint=0)
def one(task):
    task.call(add_all, EMPTY, [1], [2], 0.85, 8, gives=[[0, 0, 0], [0, 0, 0.85], [0, 0, 0]])


@check("A cell that is named twice", hint=1)
def twice(task):
    task.call(
        add_all, EMPTY, [0, 0, 1], [1, 1, 1], -0.4, 8, gives=[[0, -0.8, 0], [0, -0.4, 0], [0, 0, 0]]
    )


@check("The clamp, on both sides", hint=2)
def clamp(task):
    task.call(add_all, [[7.5, 0], [0, -1]], [0, 1], [0, 1], 0.85, 8, gives=[[8, 0], [0, -0.15]])
    task.call(add_all, [[7.5, 0], [0, -7.9]], [0, 1], [0, 1], -0.4, 8, gives=[[7.1, 0], [0, -8]])


@check("The whole grid is clamped, once and at the end", hint=2)
def at_the_end(task):
    task.call(add_all, [[5, 0], [-6, 0]], [0], [1], 0.85, 4, gives=[[4, 0.85], [-4, 0]])
    task.call(add_all, [[5, 0], [0, 0]], [0, 0], [0, 0], -0.4, 4, gives=[[4, 0], [0, 0]])


@check("A grid that is not square", hint=0)
def oblong(task):
    task.call(add_all, [[0, 0, 9], [0, 0, -9]], [1, 0, 1], [0, 1, 1], 0.85, 8)
    task.call(add_all, [[0, 0], [0, 0], [9, -9]], [1, 0, 1], [0, 1, 1], -0.4, 8)
    task.call(add_all, [[0] * 45, [9] * 45, [-9] * 45], [0, 2, 0], [1, 0, 44], 0.85, 8)


@check("Many cells", hint=1)
def many(task):
    for _ in range(2):
        grid = [[round(task.random.uniform(-3, 3), 1) for _ in range(3)] for _ in range(3)]
        # Four cells, of which two share a row, and the first of them again at the end.
        cells = task.random.sample([(row, column) for row in range(3) for column in range(3)], 4)
        rows, columns = map(list, zip(*cells, cells[0]))
        task.call(add_all, grid, rows, columns, -0.405, 3)
