# style: divmod


def hits_needed(l, l_occ):
    if l > KNOWN:
        return 0
    whole, rest = divmod(KNOWN - l, l_occ)
    return int(whole) + 1
