"""read_map(log_odds): the free and the occupied cells, by two thresholds of probability."""

from math import log, log10

from grader import (
    calls,
    check,
    code,
    either,
    function,
    lacks,
    loops,
    mistake,
    number,
    operator,
    reads,
)
from mapping.frontiers import State, states_by_probability
from mapping.log_odds import log_odds as log_odds_of


def by(free_below, occupied_above):
    """The sets that two thresholds of log odds make."""
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


right = reference(0.35, 0.65)


def with_thresholds(free_p, occ_p, mistakes):
    """The function, judged with these thresholds in the program."""
    return function(
        "read_map(log_odds)", reference(free_p, occ_p), cell_cm=5, leaves=True, mistakes=mistakes
    )


def turned(cells):
    return {(row, column) for column, row in cells}


POWERS = either(calls("exp", "pow"), operator("**"))

TYPED_IN = [
    mistake(
        "the thresholds were typed in: work them out from OCC_P and FREE_P, which may change",
        right,
        1,
        where=lacks(reads("OCC_P", "FREE_P")),
    ),
    mistake(
        "OCC_P was typed in: work out both thresholds from the names, which may change",
        lambda cells: (reference(0.3, 0.9)(cells)[0], right(cells)[1]),
        1,
        where=lacks(reads("OCC_P")),
    ),
    mistake(
        "FREE_P was typed in: work out both thresholds from the names, which may change",
        lambda cells: (right(cells)[0], reference(0.3, 0.9)(cells)[1]),
        1,
        where=lacks(reads("FREE_P")),
    ),
    mistake(
        "the sign is turned round, and the sets have changed places: with 0.35 and 0.65 that comes "
        "to the same, with other thresholds it does not",
        reference(1 - 0.9, 1 - 0.3),
        0,
        where=calls("exp"),
    ),
    (
        "both thresholds come from OCC_P: the lower one should come from FREE_P",
        reference(1 - 0.9, 0.9),
        1,
    ),
    (
        "both thresholds come from FREE_P: the upper one should come from OCC_P",
        reference(0.3, 1 - 0.3),
        1,
    ),
]

read_map = with_thresholds(
    0.35,
    0.65,
    [
        (
            "the thresholds were taken for log odds: they are probabilities, "
            "so turn them into log odds first",
            by(0.35, 0.65),
            0,
        ),
        mistake(
            "the sign is turned round: a large l is to give a large p, as in "
            "1 / (1 + math.exp(-l))",
            lambda c: right(c)[::-1],
            0,
            where=(calls("exp"), lacks(code("math.exp(-_)"))),
        ),
        mistake(
            "free and occupied have changed places: free comes first, and a large l is to give a "
            "large p",
            lambda c: right(c)[::-1],
            2,
            where=POWERS,
        ),
        mistake(
            "the two sets are the wrong way round: free comes first",
            lambda c: right(c)[::-1],
            2,
            where=lacks(POWERS),
        ),
        (
            "cells that are not free are all called occupied: most of them are unknown",
            lambda cells: (right(cells)[0], set(cells) - right(cells)[0]),
            2,
        ),
        (
            "cells that are not occupied are all called free: most of them are unknown",
            lambda cells: (set(cells) - right(cells)[1], right(cells)[1]),
            2,
        ),
        (
            "only 0 parts free from occupied: cells between the two thresholds are unknown",
            by(0, 0),
            0,
        ),
        mistake(
            "the limits are 1 and -1, those of U8.4: here they come from OCC_P and FREE_P",
            by(-1, 1),
            1,
            where=number(1),
        ),
        (
            "the odds were left without their logarithm: math.log(p / (1 - p))",
            by(0.35 / 0.65, 0.65 / 0.35),
            1,
        ),
        mistake(
            "math.log(p) is not the log odds: it is math.log(p / (1 - p))",
            by(log(0.35), log(0.65)),
            1,
            where=calls("log"),
        ),
        mistake(
            "math.log10() has the base 10: log odds are math.log(p / (1 - p))",
            by(log10(0.35 / 0.65), log10(0.65 / 0.35)),
            1,
            where=either(calls("log10"), number(10)),
        ),
        mistake(
            "only the first cell was looked at: a return inside the loop ends the function at once",
            lambda cells: right(dict([*cells.items()][:1])) if cells else None,
            2,
            where=loops(),
        ),
        (
            "math.exp(l) is the odds, not the probability: that is 1 / (1 + math.exp(-l))",
            by(log(0.35), log(0.65)),
            0,
        ),
        (
            "the odds are upside down: it is p over 1 - p",
            by(log(0.65 / 0.35), log(0.35 / 0.65)),
            1,
        ),
        (
            "in the set of occupied cells column and row are the wrong way round",
            lambda cells: (right(cells)[0], turned(right(cells)[1])),
            2,
        ),
        (
            "in the set of free cells column and row are the wrong way round",
            lambda cells: (turned(right(cells)[0]), right(cells)[1]),
            2,
        ),
        (
            "column and row are the wrong way round: the keys are the cells as they are wanted",
            lambda cells: tuple(map(turned, right(cells))),
            2,
        ),
        (
            "the lower threshold was taken for log odds: it is a probability, so turn it into log "
            "odds as well",
            lambda cells: (
                by(0.35, 0)(cells)[0] - right(cells)[1],
                right(cells)[1],
            ),
            0,
        ),
        (
            "the upper threshold was taken for log odds: it is a probability, so turn it into log "
            "odds as well",
            lambda cells: (right(cells)[0], by(0, 0.65)(cells)[1]),
            0,
        ),
    ],
)
apart = with_thresholds(0.3, 0.9, TYPED_IN)
touching = with_thresholds(
    0.5,
    0.5,
    [
        (
            "a threshold itself counts as unknown: above OCC_P and below FREE_P, not equal to it",
            lambda cells: (
                {cell for cell, value in cells.items() if value <= 0},
                {cell for cell, value in cells.items() if value >= 0},
            ),
            2,
        ),
        (
            "a cell at FREE_P itself counts as unknown: free is below it, not equal to it",
            lambda cells: (
                {cell for cell, value in cells.items() if value <= 0},
                by(0, 0)(cells)[1],
            ),
            2,
        ),
        (
            "a cell at OCC_P itself counts as unknown: occupied is above it, not equal to it",
            lambda cells: (
                by(0, 0)(cells)[0],
                {cell for cell, value in cells.items() if value >= 0},
            ),
            2,
        ),
    ],
)
ABOVE = {(0, 0): 0.0, (1, 0): 0.2, (2, 0): 0.5, (3, 0): 1.0, (4, 0): 1.6}
above_half = with_thresholds(
    0.6,
    0.8,
    [
        (
            "a cell with log odds of 0 was left out: with these thresholds 0 is below FREE_P too",
            lambda cells: reference(0.6, 0.8)({c: l for c, l in cells.items() if l}),
            0,
        )
    ],
)
below_half = with_thresholds(
    0.2,
    0.4,
    [
        (
            "a cell with log odds of 0 was left out: with these thresholds 0 is above OCC_P too",
            lambda cells: reference(0.2, 0.4)({c: l for c, l in cells.items() if l}),
            0,
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
    task.call(read_map, {}, gives=(set(), set()))


@check("Other thresholds", hint=1)
def other(task):
    task.set("OCC_P", 0.9)
    task.set("FREE_P", 0.3)
    for _ in range(4):
        task.call(apart, some_map(task))
    task.call(apart, {(column, 3): log_odds_of(0.095 + 0.01 * column) for column in range(89)})


@check("Both thresholds on one side of 0.5", hint=0)
def one_side(task):
    task.set("OCC_P", 0.8)
    task.set("FREE_P", 0.6)
    task.call(above_half, ABOVE, gives=({(0, 0), (1, 0)}, {(4, 0)}))
    task.set("FREE_P", 0.2)
    task.set("OCC_P", 0.4)
    task.call(
        below_half, {cell: -l for cell, l in ABOVE.items()}, gives=({(4, 0)}, {(0, 0), (1, 0)})
    )


@check("Just at a threshold", hint=2)
def border(task):
    task.set("OCC_P", 0.5)
    task.set("FREE_P", 0.5)
    task.call(touching, {(0, 0): -0.1, (1, 0): 0.0, (2, 0): 0.1}, gives=({(0, 0)}, {(2, 0)}))
