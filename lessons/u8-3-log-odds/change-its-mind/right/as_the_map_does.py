# style: a cell that is hit and clamped as in the map
def hits_needed(l, l_occ):
    hits, lowest, highest = 0, -8, 8
    while not l > KNOWN:
        l = min(highest, max(lowest, l + l_occ))
        hits += 1
    return hits
