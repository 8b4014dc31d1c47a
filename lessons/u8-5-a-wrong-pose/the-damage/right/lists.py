# style: lists in place of tuples
def drifted(looks, rate):
    """The looks with a heading that drifts by so many degrees/s."""
    return [[t, (facing + rate * t), list(readings)] for t, facing, readings in looks]


def experiment(looks):
    """Print, for each of DRIFTS, how much of the map is wrong."""
    for rate in DRIFTS:
        free, occupied = map_of(drifted(looks, rate))
        show(free, occupied)
        print(f"drift {rate}: {wrong_percent(occupied):.1f} % wrong")
