# style: one loop with flags
def reason(seconds, driven, regions, ways):
    if seconds >= MAX_TIME:
        return "time is up"
    some = large = reachable = False
    for i in range(len(regions)):
        some = True
        if regions[i] < MIN_REGION:
            continue
        large = True
        if ways[i] is None:
            continue
        reachable = True
        if driven + ways[i] <= MAX_WAY:
            return None
    if not some:
        return "no frontier is left"
    elif not large:
        return "only small frontiers are left"
    elif not reachable:
        return "no frontier can be reached"
    return "the rest is too far"
