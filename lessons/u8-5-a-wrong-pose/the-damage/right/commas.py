# style: print() with commas, which sets blanks
def drifted(looks, rate):
    return [(t, facing + t * rate, readings) for t, facing, readings in looks]


def experiment(looks):
    for rate in DRIFTS:
        free, occupied = map_of(drifted(looks, rate))
        show(free, occupied)
        print("drift", rate, ":", wrong_percent(occupied), "% wrong")
