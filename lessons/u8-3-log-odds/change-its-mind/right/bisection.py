# style: bisection


def hits_needed(l, l_occ):
    low, high = -1, 10000
    while high - low > 1:
        middle = (low + high) // 2
        if l + middle * l_occ > KNOWN:
            high = middle
        else:
            low = middle
    return high
