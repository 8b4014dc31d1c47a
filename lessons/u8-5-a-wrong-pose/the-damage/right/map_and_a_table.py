# style: map() with a function inside, figures gathered before they are printed
def drifted(looks, rate):
    """The looks with a heading that drifts by so many degrees/s."""

    def turned(look):
        return look[0], look[1] + look[0] * rate, look[2]

    return list(map(turned, looks))


def experiment(looks):
    """Print, for each of DRIFTS, how much of the map is wrong."""
    figures = {}
    for rate in DRIFTS:
        free, occupied = map_of(drifted(looks, rate))
        show(free, occupied)
        figures[rate] = wrong_percent(occupied)
    for rate, percent in figures.items():
        print(f"drift {rate}: {round(percent, 1)} % wrong")
