"""fuse(readings): many probabilities into one, by adding their log odds."""

from math import prod

from grader import check, function, loops, mistake, near, operator, reads
from mapping.log_odds import log_odds, probability


def total(readings):
    return sum(log_odds(p) for p in readings)


def fused(readings):
    return probability(total(readings))


def if_any(answer):
    """What a mistake answers where there are readings; no idea where there are none."""
    return lambda readings: answer(readings) if readings else 0.5


def needs_a_reading(readings):
    return fused(readings[:1] + readings[1:]) if readings else readings[0]


OF_THE_PROGRAM = [0.7, 0.7, 0.4, 0.7, 0.4, 0.4, 0.4, 0.7, 0.7, 0.7]
ROUNDED = "the answer was rounded: return it with all its decimals"

fuse = function(
    "fuse(readings)",
    fused,
    compare=near(0.0001),
    leaves=True,
    mistakes=[
        mistake(
            "that is the average of the readings: ten readings of 0.7 should leave no doubt, and "
            "their average is still 0.7",
            if_any(lambda readings: sum(readings) / len(readings)),
            0,
            where=operator("/", "//"),
        ),
        mistake(
            "that is the average of the log odds: evidence adds up, so don't divide",
            if_any(lambda readings: probability(total(readings) / len(readings))),
            0,
            where=operator("/", "//"),
        ),
        (
            "only the largest reading counts here: every reading is evidence",
            if_any(max),
            0,
        ),
        ("p was added, not log odds: turn each reading into log odds, then add", sum, 0),
        (
            "p was added to 0.5, not log odds: turn each reading into log odds, then add",
            lambda readings: 0.5 + sum(readings),
            0,
        ),
        (
            "p was added, not log odds: turn each reading into log odds before you add it",
            lambda readings: probability(sum(readings)),
            1,
        ),
        ("the probabilities were multiplied: it is their log odds that add", prod, 0),
        (
            "the probabilities were multiplied: it is their log odds that add",
            lambda readings: 0.5 * prod(readings),
            0,
        ),
        (
            "that is the chance that at least one reading is right: every reading counts, those "
            "below 0.5 against",
            lambda readings: 1 - prod(1 - p for p in readings),
            0,
        ),
        ("those are log odds: turn the sum back into a probability", total, 2),
        (
            "the sum began at 0.5: in log odds, no idea is 0",
            lambda readings: probability(0.5 + total(readings)),
            1,
        ),
        (
            "the sum began at 1: in log odds, no idea is 0",
            lambda readings: probability(1 + total(readings)),
            1,
        ),
        (
            "the log odds were subtracted: a reading above 0.5 speaks for it, so add",
            lambda readings: probability(-total(readings)),
            1,
        ),
        (
            "only the last reading counts: use += to add it to what is there, = throws the others "
            "away",
            if_any(lambda readings: readings[-1]),
            1,
        ),
        (
            "the first reading is left out: go through all of them",
            lambda readings: fused(readings[1:]),
            1,
        ),
        (
            "the last reading is left out: go through all of them",
            lambda readings: fused(readings[:-1]),
            1,
        ),
        mistake(
            "only the first reading counts: the return is inside the loop, so the first time "
            "round ends it",
            if_any(lambda readings: readings[0]),
            2,
            where=loops(),
        ),
        mistake(
            "READINGS was used: the function must fuse the readings that it is given",
            lambda readings: fused(OF_THE_PROGRAM),
            1,
            where=reads("READINGS"),
        ),
        (
            "an empty list has no first reading: begin with l = 0.0, then add all of them",
            needs_a_reading,
            1,
        ),
        (ROUNDED, lambda readings: round(fused(readings), 1), 2),
        (ROUNDED, lambda readings: round(fused(readings), 2), 2),
        (ROUNDED, lambda readings: round(fused(readings), 3), 2),
    ],
)


@check("No readings, or one", hint=1)
def few(task):
    task.call(fuse, [], gives=0.5)
    task.call(fuse, [0.7], gives=0.7)


@check("Readings that agree are surer together", hint=0)
def agree(task):
    task.call(fuse, [0.7, 0.7], gives=0.84483)
    task.call(fuse, [0.4, 0.4, 0.4])
    task.call(fuse, [0.7] * 10)


@check("Readings that contradict each other", hint=0)
def against(task):
    task.call(fuse, [0.7, 0.3], gives=0.5)
    task.call(fuse, [0.7, 0.4, 0.4, 0.7, 0.4])


@check("Any readings, in any order", hint=2)
def mixed(task):
    for length in (3, 8, 20):
        task.call(fuse, [task.random.choice((0.2, 0.4, 0.7, 0.9)) for _ in range(length)])
