# style: Bayes' rule


def fuse(readings):
    belief = 0.5
    for p in readings:
        belief = belief * p / (belief * p + (1 - belief) * (1 - p))
    return belief
