# style: decimals

from decimal import Decimal


def log_odds(p):
    p = Decimal(p)
    return (p / (1 - p)).ln()


def probability(l):
    return 1 / (1 + Decimal(-l).exp())
