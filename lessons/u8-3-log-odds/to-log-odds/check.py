"""log_odds(p) and probability(l): there and back."""

from math import exp, inf, log, log1p, log2, log10

from grader import calls, check, code, either, function, mistake, near, number
from mapping import log_odds as reference

NO_BRACKETS = (
    "brackets are missing: p / 1 - p divides by 1 only and leaves 0 for the logarithm; write "
    "p / (1 - p)"
)
ROUNDED = "the answer was rounded: return it with all its decimals"


HELD = "p or l is held within limits: take both as they are, however small or large"


def held(right, low, high):
    """What a mistake answers that holds the right number between low and high."""
    return lambda value: max(low, min(high, right(value)))


def rounded(right, digits):
    """What a mistake answers that rounds the right number."""
    return lambda value: round(right(value), digits)


log_odds = function(
    "log_odds(p)",
    reference.log_odds,
    compare=near(1e-7),
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
        mistake(
            "the sign is turned round: there is a minus too many",
            lambda p: log((1 - p) / p),
            0,
            where=code("-_"),
        ),
        (
            "the odds are upside down: p speaks for it, 1 - p against it, so it is p over 1 - p",
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
            "brackets are missing: math.log(1) - p takes the logarithm of 1 only; write "
            "math.log(1 - p)",
            lambda p: log(p) - p,
            1,
            where=code("math.log(1) - p", "_ - math.log(1) - p"),
        ),
        mistake(
            NO_BRACKETS,
            lambda p: -inf,
            1,
            where=code("_ / 1 - _"),
        ),
        *((ROUNDED, rounded(reference.log_odds, digits), 2) for digits in range(1, 7)),
        *(
            mistake(HELD, held(reference.log_odds, -limit, limit), 2, where=number(limit))
            for limit in (4, 4.6, 5, 6, 7, 8)
        ),
        mistake(
            HELD,
            lambda p: reference.log_odds(max(0.01, min(0.99, p))),
            2,
            where=number(0.01, 0.99),
        ),
    ],
)

probability = function(
    "probability(l)",
    reference.probability,
    compare=near(1e-7),
    mistakes=[
        (
            "those are the odds, not the probability: odds o make the probability o / (1 + o)",
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
            where=code("1 / (1 + math.exp(l))"),
        ),
        (
            "that is 1 - p, the probability of free: a large l is to give a large p",
            lambda l: 1 / (1 + exp(l)),
            2,
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
            "a plus sign is wanted below the line: math.exp(l) / (1 + math.exp(l))",
            lambda l: exp(l) / (1 - exp(l)),
            2,
            where=code("_ / (1 - _)"),
        ),
        (
            "this is 1 divided by p: write 1 / (1 + math.exp(-l))",
            lambda l: 1 + exp(-l),
            2,
        ),
        mistake(
            "brackets are missing: ... / 1 + ... divides by 1 only; write ... / (1 + ...)",
            lambda l: exp(l) / 1 + exp(l),
            2,
            where=code("_ / 1 + _"),
        ),
        mistake(
            "the sign of l was lost: below 0 it gives a probability below 0.5",
            lambda l: reference.probability(abs(l)),
            2,
            where=calls("abs", "fabs"),
        ),
        mistake(
            "the number e is typed in with too few digits: use math.exp()",
            lambda l: 1 / (1 + 2.718**-l),
            2,
            where=number(2.718),
        ),
        mistake(
            "the number e is typed in with too few digits: use math.exp()",
            lambda l: 1 / (1 + 2.72**-l),
            2,
            where=number(2.72),
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
        *((ROUNDED, rounded(reference.probability, digits), 2) for digits in range(1, 7)),
        mistake(
            HELD,
            lambda l: reference.probability(max(-8, min(8, l))),
            2,
            where=number(8),
        ),
        mistake(
            HELD,
            lambda l: reference.probability(l) if -8 <= l <= 8 else int(l > 0),
            2,
            where=number(8),
        ),
    ],
)


@check("As likely as not is 0", hint=0)
def even(task):
    task.call(log_odds, 0.5, gives=0)


@check("The log odds of a probability", hint=1)
def there(task):
    for p in (0.7, 0.4, 0.9, 0.01, 0.0001, 0.99999):
        task.call(log_odds, p)


@check("The probability of log odds", hint=2)
def back(task):
    task.call(probability, 0, gives=0.5)
    for l in (0.85, -0.4, 8, -8, 12, -12):
        task.call(probability, l)


@check("Any probability, there and back", hint=2)
def both(task):
    for _ in range(10):
        p = round(task.random.uniform(0.01, 0.99), 2)
        task.call(log_odds, p)
        task.call(probability, round(reference.log_odds(p), 3))
