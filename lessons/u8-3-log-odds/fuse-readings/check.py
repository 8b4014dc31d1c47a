"""fuse(readings): many probabilities into one, by adding their log odds."""

from math import exp, prod

from grader import calls, check, function, loops, mistake, near, operator, reads
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


def clamped(readings):
    l = 0.0
    for p in readings:
        l = max(-8.0, min(8.0, l + log_odds(p)))
    return probability(l)


OF_THE_PROGRAM = [0.7, 0.7, 0.4, 0.7, 0.4, 0.4, 0.4, 0.7, 0.7, 0.7]
ROUNDED = "the answer was rounded: return it with all its decimals"

# What the learner is told, what the mistake answers, the hint, and what must stand in the function.
SLIPS = [
    (
        "that is the average of the readings: ten readings of 0.7 should leave no doubt, and "
        "their average is still 0.7",
        lambda readings: sum(readings) / len(readings),
        0,
        operator("/", "//"),
    ),
    (
        "that is the average of the log odds: evidence adds up, so don't divide",
        lambda readings: probability(total(readings) / len(readings)),
        0,
        operator("/", "//"),
    ),
    (
        "only the largest reading counts here: every reading is evidence",
        max,
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
    (
        "the log odds were multiplied: evidence adds up, so begin with 0 and add them",
        lambda readings: probability(prod(log_odds(p) for p in readings)),
        0,
    ),
    ("those are log odds: turn the sum back into a probability", total, 2),
    (
        "those are odds: turn them back into a probability, odds / (1 + odds)",
        lambda readings: exp(total(readings)),
        2,
    ),
    (
        "0.85 and -0.4 were added, whatever the reading says: add the log odds of each reading, "
        "log_odds(p)",
        lambda readings: probability(sum(0.85 if p > 0.5 else -0.4 for p in readings)),
        1,
    ),
    ("the sum was clamped: here it should go as far as the readings take it", clamped, 1),
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
        "only the last reading counts: use += to add it to what is there, = throws the others away",
        lambda readings: readings[-1],
        1,
    ),
    (
        "the first reading counts twice: begin with no idea, 0 in log odds, or leave it out of "
        "the loop",
        lambda readings: fused(readings[:1] + readings),
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
    (
        "only the first reading counts: the return is inside the loop, so the first time "
        "round ends it",
        lambda readings: readings[0],
        2,
        loops(),
    ),
    (
        "readings that are equal count only once: each of them is evidence, so don't make a set",
        lambda readings: fused(set(readings)),
        0,
        calls("set"),
    ),
    (
        "READINGS was used: the function must fuse the readings that it is given",
        lambda readings: fused(OF_THE_PROGRAM),
        1,
        reads("READINGS"),
    ),
    (
        "an empty list has no first reading: begin with l = 0.0, then add all of them",
        needs_a_reading,
        1,
    ),
    (ROUNDED, lambda readings: round(fused(readings), 1), 2),
    (ROUNDED, lambda readings: round(fused(readings), 2), 2),
    (ROUNDED, lambda readings: round(fused(readings), 3), 2),
]

fuse = function(
    "fuse(readings)",
    fused,
    compare=near(0.0001),
    leaves=True,
    mistakes=[
        mistake(text, answer, hint, where=conditions)
        for text, slip, hint, *conditions in SLIPS
        for answer in (slip, if_any(slip))
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
