"""log_odds(p) and probability(l): there and back."""

from math import exp, inf, log, log1p, log2, log10

from grader import calls, check, code, either, function, mistake, near, number
from mapping import log_odds as reference

NO_BRACKETS = (
    "brackets are missing: p / 1 - p divides by 1 only and leaves 0 for the logarithm; write "
    "p / (1 - p)"
)
ROUNDED = "the answer was rounded: return it with all its decimals"


def rounded(right, digits):
    """What a mistake answers that rounds the right number."""
    return lambda value: round(right(value), digits)


log_odds = function(
    "log_odds(p)",
    reference.log_odds,
    compare=near(0.0001),
    mistakes=[
        (
            "that is the logarithm to base 10: log odds use the natural one, math.log()",
            lambda p: log10(p / (1 - p)),
            1,
        ),
        (
            "that is the logarithm to base 2: log odds use the natural one, math.log()",
            lambda p: log2(p / (1 - p)),
            1,
        ),
        mistake(
            "math.log1p() adds 1 before it takes the logarithm: use math.log()",
            lambda p: log1p(p / (1 - p)),
            1,
            where=calls("log1p"),
        ),
        (
            "these are the odds, not yet their logarithm: put math.log() round p / (1 - p)",
            lambda p: p / (1 - p),
            1,
        ),
        ("that is the logarithm of p itself: divide p by 1 - p first", log, 0),
        (
            "the odds are upside down: p is for, 1 - p against, so it is p over 1 - p",
            lambda p: log((1 - p) / p),
            0,
        ),
        mistake(
            "two logarithms were divided: divide p by 1 - p first, then take one logarithm",
            lambda p: log(p) / log(1 - p),
            0,
            where=calls("log"),
        ),
        (
            "the logarithm was taken of p alone: it belongs round all of p / (1 - p)",
            lambda p: log(p) / (1 - p),
            1,
        ),
        mistake(
            NO_BRACKETS,
            lambda p: log(p / 1 - p),
            1,
            where=code("_ / 1 - _"),
        ),
        mistake(
            NO_BRACKETS,
            lambda p: -inf,
            1,
            where=code("_ / 1 - _"),
        ),
        (ROUNDED, rounded(reference.log_odds, 1), 2),
        (ROUNDED, rounded(reference.log_odds, 2), 2),
        (ROUNDED, rounded(reference.log_odds, 3), 2),
    ],
)

probability = function(
    "probability(l)",
    reference.probability,
    compare=near(0.0001),
    mistakes=[
        (
            "those are the odds, not the probability: odds of o are a probability of o / (1 + o)",
            exp,
            2,
        ),
        (
            "those are the odds against: 1 divided by 1 plus that is the probability",
            lambda l: exp(-l),
            2,
        ),
        mistake(
            "the sign of l is turned round: with math.exp(l) below the line, a large l gives a "
            "small p",
            lambda l: 1 / (1 + exp(l)),
            2,
            where=calls("exp", "pow", "e"),
        ),
        (
            "undo the logarithm first, with math.exp(): l / (1 + l) takes log odds for odds",
            lambda l: l / (1 + l),
            1,
        ),
        mistake(
            "brackets are missing: 1 / 1 + ... divides by 1 only; write 1 / (1 + ...)",
            lambda l: 1 / 1 + exp(-l),
            2,
            where=code("1 / 1 + _"),
        ),
        (
            "a plus sign is wanted below the line: 1 / (1 + math.exp(-l))",
            lambda l: 1 / (1 - exp(-l)),
            2,
        ),
        mistake(
            "powers of 10 undo the logarithm to base 10: math.exp() undoes math.log()",
            lambda l: 1 / (1 + 10**-l),
            1,
            where=number(10),
        ),
        mistake(
            "powers of 2 undo the logarithm to base 2: math.exp() undoes math.log()",
            lambda l: 1 / (1 + 2**-l),
            1,
            where=either(number(2), calls("exp2")),
        ),
        (ROUNDED, rounded(reference.probability, 1), 2),
        (ROUNDED, rounded(reference.probability, 2), 2),
        (ROUNDED, rounded(reference.probability, 3), 2),
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
