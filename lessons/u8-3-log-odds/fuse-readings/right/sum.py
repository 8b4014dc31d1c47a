# style: sum and map


def fuse(readings):
    return probability(sum(map(log_odds, readings)))
