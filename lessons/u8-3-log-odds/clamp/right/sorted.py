# style: the middle one of three


def add(l, evidence, limit):
    return sorted([-limit, l + evidence, limit])[1]
