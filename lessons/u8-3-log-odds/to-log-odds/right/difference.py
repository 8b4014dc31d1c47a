# style: a difference of logarithms


def log_odds(p):
    return math.log(p) - math.log(1 - p)


def probability(l):
    return math.exp(l) / (1 + math.exp(l))
