# style: recursion


def hits_needed(l, l_occ):
    return 0 if l > KNOWN else 1 + hits_needed(l + l_occ, l_occ)
