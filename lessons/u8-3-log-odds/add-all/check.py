"""add_all(grid, rows, columns, evidence, limit): NumPy adds to many cells at once."""

from grader import calls, check, code, either, function, loops, mistake, near, number, reads


def clamped(grid, low, high):
    return [[max(low, min(high, l)) for l in row] for row in grid]


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

add_all = function(
    "add_all(grid, rows, columns, evidence, limit)",
    add_each,
    compare=near(0.0001),
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
            lambda grid, rows, columns, evidence, limit: add_each(
                grid, columns, rows, evidence, limit
            ),
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


@check("Many cells", hint=1)
def many(task):
    cells = range(6)
    grid = [[round(task.random.uniform(-3, 3), 1) for _ in cells] for _ in cells]
    rows, columns = ([task.random.choice(cells) for _ in range(30)] for _ in range(2))
    task.call(add_all, grid, rows, columns, -0.4, 3)
