# style: a formula


def hits_needed(l, l_occ):
    return max(0, math.floor((KNOWN - l) / l_occ) + 1)
