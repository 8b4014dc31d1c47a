# style: two ifs


def add(l, evidence, limit):
    total = l + evidence
    if total > limit:
        return limit
    if total < -limit:
        return -limit
    return total
