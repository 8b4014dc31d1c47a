# style: bisection


def log_odds(p):
    return math.log(p / (1 - p))


def probability(l):
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = (low + high) / 2
        if log_odds(middle) < l:
            low = middle
        else:
            high = middle
    return (low + high) / 2
