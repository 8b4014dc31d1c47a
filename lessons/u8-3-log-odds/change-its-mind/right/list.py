# style: a list of all the log odds


def hits_needed(l, l_occ):
    values = [l]
    while values[-1] <= KNOWN:
        values.append(values[-1] + l_occ)
    return len(values) - 1
