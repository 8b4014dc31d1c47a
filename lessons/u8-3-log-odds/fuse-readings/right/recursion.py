# style: recursion


def fuse(readings):
    if not readings:
        return 0.5
    first, *others = readings
    return probability(log_odds(first) + log_odds(fuse(others)))
