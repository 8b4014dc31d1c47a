# style: a helper function, a frozenset and a named tuple
from typing import NamedTuple


class Sorted(NamedTuple):
    free: frozenset
    occupied: frozenset


def logit(p):
    return math.log(p) - math.log(1 - p)


def read_map(log_odds):
    low, high = map(logit, (FREE_P, OCC_P))
    return Sorted(
        free=frozenset(cell for cell in log_odds if log_odds[cell] < low),
        occupied=frozenset(cell for cell in log_odds if log_odds[cell] > high),
    )
