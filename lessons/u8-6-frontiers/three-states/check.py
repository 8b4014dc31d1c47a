"""read_map(log_odds): the free and the occupied cells, by two thresholds of probability."""

from grader import check, function
from mapping.frontiers import State, states_by_probability
from mapping.log_odds import log_odds as log_odds_of


def by(free_below, occupied_above):
    """The reference, or a slip of it, by thresholds of log odds."""
    return lambda cells: (
        {cell for cell, value in cells.items() if value < free_below},
        {cell for cell, value in cells.items() if value > occupied_above},
    )


def reference(free_p, occ_p):
    def read_map(cells):
        states = dict(zip(cells, states_by_probability(cells.values(), free_p, occ_p)))
        return (
            {cell for cell in cells if states[cell] is State.FREE},
            {cell for cell in cells if states[cell] is State.OCCUPIED},
        )

    return read_map


def swapped(cells):
    return reference(0.35, 0.65)(cells)[::-1]


def two_states(cells):
    free, _ = reference(0.35, 0.65)(cells)
    return free, set(cells) - free


def two_states_all_free(cells):
    _, occupied = reference(0.35, 0.65)(cells)
    return set(cells) - occupied, occupied


MISTAKES = [
    (
        "the thresholds look taken for log odds: they are probabilities, "
        "so turn them into log odds first",
        by(0.35, 0.65),
        0,
    ),
    ("the two sets look swapped: free comes first", swapped, 2),
    (
        "cells that are not free are all called occupied: most of them are unknown",
        two_states,
        2,
    ),
    (
        "cells that are not occupied are all called free: most of them are unknown",
        two_states_all_free,
        2,
    ),
    (
        "1 and -1 look used, the limits of U8.4: here the limits come from OCC_P and FREE_P",
        by(-1, 1),
        1,
    ),
    (
        "the odds look left without their logarithm: math.log(p / (1 - p))",
        by(0.35 / 0.65, 0.65 / 0.35),
        1,
    ),
]
read_map = function("read_map(log_odds)", reference(0.35, 0.65), cell_cm=5, mistakes=MISTAKES)
strict = function(
    "read_map(log_odds)",
    reference(0.05, 0.95),
    cell_cm=5,
    mistakes=[
        (
            "the thresholds look typed in: work them out from OCC_P and FREE_P, which may change",
            reference(0.35, 0.65),
            1,
        )
    ],
)


def some_map(task):
    cells = [(column, row) for row in range(6) for column in range(6)]
    return {
        cell: round(task.random.choice([0, 0.85, task.random.uniform(-8, 8)]), 2) for cell in cells
    }


@check("Four cells", hint=0)
def four(task):
    cells = {(0, 0): -0.8, (1, 0): 0.0, (2, 0): 0.85, (3, 0): -0.4}
    task.call(read_map, cells, gives=({(0, 0)}, {(2, 0)}))


@check("Maps of all kinds", hint=2)
def many(task):
    for _ in range(6):
        task.call(read_map, some_map(task))
    task.call(read_map, {(column, 3): log_odds_of(0.305 + 0.01 * column) for column in range(41)})


@check("Other thresholds", hint=1)
def other(task):
    task.set("OCC_P", 0.95)
    task.set("FREE_P", 0.05)
    for _ in range(4):
        task.call(strict, some_map(task))
