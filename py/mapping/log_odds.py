"""Probabilities as log odds: adding what Bayes' rule would multiply.

May import: the standard library, `bugbot.errors`.

With l = ln(p / (1 - p)), and readings that are independent given the map, Bayes' rule for a cell
becomes "add the log odds of the reading" (Thrun, Burgard, Fox, "Probabilistic Robotics",
2005, 4.2 and 9.2). 0 is "no idea", +0.85 a 70 % sure hit, -0.4 a 60 % sure pass.
"""

from __future__ import annotations

from math import exp, log

from bugbot.errors import WrongValueError, got

__all__ = ["KNOWN", "L_FREE", "L_MAX", "L_OCC", "clamped", "log_odds", "probability"]

L_OCC = 0.85
"""Evidence of a beam that ended in a cell: p = 0.70."""

L_FREE = -0.4
"""Evidence of a beam that passed through a cell: p = 0.40, so 60 % sure that it is free."""

L_MAX = 8.0
"""Log odds are kept between -L_MAX and L_MAX, so that a map can still change its mind."""

KNOWN = 1.0
"""A cell counts as known when its log odds are beyond this, either way: p > 0.73 or < 0.27."""


def log_odds(p: float) -> float:
    """Log odds of a probability, 0 and 1 excluded; WrongValueError for anything else.

    >>> round(log_odds(0.7), 2), log_odds(0.5)
    (0.85, 0.0)
    """
    if not 0.0 < p < 1.0:  # False for NaN too
        raise WrongValueError(
            f"log_odds(p) wants a probability above 0 and below 1; it got {got(p)}"
        )
    return log(p / (1.0 - p))


def probability(l: float) -> float:  # noqa: E741 - the field's own letter
    """Probability of log odds; 1.0 or 0.0 where the difference no longer fits a float.

    >>> round(probability(0.85), 2), probability(0)
    (0.7, 0.5)
    """
    # Either form alone would overflow for log odds beyond about 700 on one side.
    if l >= 0.0:
        return 1.0 / (1.0 + exp(-l))
    odds = exp(l)
    return odds / (1.0 + odds)


def clamped(l: float, limit: float = L_MAX) -> float:  # noqa: E741
    """Log odds kept between -limit and limit.

    >>> clamped(9.3), clamped(-0.4)
    (8.0, -0.4)
    """
    return max(-limit, min(limit, l))
