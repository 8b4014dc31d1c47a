"""fuse(readings): many probabilities into one, by adding their log odds."""

from math import prod

from grader import check, function, near
from mapping.log_odds import log_odds, probability


def total(readings):
    return sum(log_odds(p) for p in readings)


def fused(readings):
    return probability(total(readings))


fuse = function(
    "fuse(readings)",
    fused,
    compare=near(0.001),
    mistakes=[
        (
            "that is the average of the readings: ten readings of 0.7 "
            "should leave no doubt, and their average is still 0.7",
            lambda readings: sum(readings) / len(readings) if readings else 0.5,
            0,
        ),
        ("p added instead of log odds: turn each reading into log odds, then add", sum, 0),
        (
            "p added to 0.5 instead of log odds: turn each reading into log odds, then add",
            lambda readings: 0.5 + sum(readings),
            0,
        ),
        ("the probabilities look multiplied: it is their log odds that add", prod, 0),
        (
            "that is the chance that at least one reading is right: "
            "every reading counts, those below 0.5 against",
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
            "only the last reading counts: use += to add it to "
            "what is there, = throws the others away",
            lambda readings: probability(log_odds(readings[-1])) if readings else 0.5,
            1,
        ),
        (
            "only the first reading counts: the return is inside "
            "the loop, so the first time round ends it",
            lambda readings: readings[0] if readings else 0.5,
            2,
        ),
    ],
)


@check("No readings at all, or one", hint=1)
def few(task):
    task.call(fuse, [], gives=0.5)
    task.call(fuse, [0.7], gives=0.7)


@check("Readings that agree are surer together", hint=0)
def agree(task):
    task.call(fuse, [0.7, 0.7], gives=0.8448)
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
