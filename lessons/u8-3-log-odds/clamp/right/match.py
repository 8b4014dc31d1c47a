# style: match


def add(l, evidence, limit):
    match l + evidence:
        case total if abs(total) <= limit:
            return total
        case total if total > 0:
            return limit
        case _:
            return -limit
