# style: hyperbolic functions


def log_odds(p):
    return 2 * math.atanh(2 * p - 1)


def probability(l):
    return 0.5 * (1 + math.tanh(l / 2))
