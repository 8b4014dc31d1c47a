"""log_odds(p) and probability(l): there and back."""

from math import exp, log, log10

from grader import check, function, near
from mapping import log_odds as reference

log_odds = function(
    "log_odds(p)",
    reference.log_odds,
    compare=near(0.005),
    mistakes=[
        (
            "that is the logarithm to base 10: log odds use the natural one, math.log()",
            lambda p: log10(p / (1 - p)),
            2,
        ),
        (
            "these are the odds, not yet their logarithm: put math.log() round p / (1 - p)",
            lambda p: p / (1 - p),
            1,
        ),
        ("that is the logarithm of p itself: divide p by 1 - p first", log, 0),
        (
            "the odds look upside down: p is for, 1 - p against, so it is p over 1 - p",
            lambda p: log((1 - p) / p),
            0,
        ),
    ],
)

probability = function(
    "probability(l)",
    reference.probability,
    compare=near(0.0005),
    mistakes=[
        (
            "those are the odds, not the probability: odds of o are a probability of o / (1 + o)",
            exp,
            2,
        ),
        (
            "the sign of l looks turned round: with math.exp(l) "
            "below the line, a large l gives a small p",
            lambda l: 1 / (1 + exp(l)),
            2,
        ),
        (
            "undo the logarithm first, with math.exp(): l / (1 + l) takes log odds for odds",
            lambda l: l / (1 + l),
            1,
        ),
    ],
)


@check("As likely as not is 0", hint=0)
def even(task):
    task.call(log_odds, 0.5, gives=0)


@check("The log odds of a probability", hint=1)
def there(task):
    for p in (0.7, 0.4, 0.9, 0.01):
        task.call(log_odds, p)


@check("The probability of log odds", hint=2)
def back(task):
    task.call(probability, 0, gives=0.5)
    for l in (0.85, -0.4, 8, -8):
        task.call(probability, l)


@check("Any probability, there and back", hint=2)
def both(task):
    for _ in range(10):
        p = round(task.random.uniform(0.01, 0.99), 2)
        task.call(log_odds, p)
        task.call(probability, round(reference.log_odds(p), 3))
