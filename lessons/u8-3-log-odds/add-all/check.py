"""add_all(grid, rows, columns, evidence, limit): NumPy adds to many cells at once."""

from grader import check, function, near


def add_each(grid, rows, columns, evidence, limit, clamp=True):
    out = [list(row) for row in grid]
    for row, column in zip(rows, columns):
        out[row][column] += evidence
    return [[max(-limit, min(limit, l)) if clamp else l for l in row] for row in out]


def once(grid, rows, columns, evidence, limit):
    pairs = sorted(set(zip(rows, columns)))
    return add_each(
        grid, [row for row, _ in pairs], [column for _, column in pairs], evidence, limit
    )


add_all = function(
    "add_all(grid, rows, columns, evidence, limit)",
    add_each,
    compare=near(0.0001),
    mistakes=[
        (
            "a repeated cell counted once: grid[rows, columns] += "
            "evidence does that; np.add.at() counts every one",
            once,
            1,
        ),
        (
            "there is no clamp: np.clip() changes nothing in place, it gives back a new array",
            lambda grid, rows, columns, evidence, limit: add_each(
                grid, rows, columns, evidence, limit, clamp=False
            ),
            2,
        ),
        (
            "row and column look swapped: grid[row, column], with the row first",
            lambda grid, rows, columns, evidence, limit: add_each(
                grid, columns, rows, evidence, limit
            ),
            0,
        ),
        (
            "a repeated cell counted once, and there is no clamp",
            lambda grid, rows, columns, evidence, limit: once(grid, rows, columns, evidence, 1e9),
            1,
        ),
        (
            "it is clamped only at the top: np.minimum() holds one side, np.clip() both",
            lambda grid, rows, columns, evidence, limit: [
                [min(limit, l) for l in row]
                for row in add_each(grid, rows, columns, evidence, limit, clamp=False)
            ],
            2,
        ),
        (
            "the evidence went to every cell: only the named ones get it",
            lambda grid, rows, columns, evidence, limit: [
                [max(-limit, min(limit, l + evidence)) for l in row] for row in grid
            ],
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


@check("Many cells", hint=1)
def many(task):
    cells = range(6)
    grid = [[round(task.random.uniform(-3, 3), 1) for _ in cells] for _ in cells]
    rows, columns = ([task.random.choice(cells) for _ in range(30)] for _ in range(2))
    task.call(add_all, grid, rows, columns, -0.4, 3)
