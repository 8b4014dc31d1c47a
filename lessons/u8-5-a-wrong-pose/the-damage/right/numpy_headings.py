# style: NumPy for the headings
import numpy as np


def drifted(looks, rate):
    """The looks with a heading that drifts by so many degrees/s."""
    times = np.array([look[0] for look in looks])
    facings = np.array([look[1] for look in looks]) + rate * times
    return [(t, facing, look[2]) for t, facing, look in zip(times, facings, looks)]


def experiment(looks):
    """Print, for each of DRIFTS, how much of the map is wrong."""
    for rate in DRIFTS:
        free, occupied = map_of(drifted(looks, rate))
        show(free, occupied)
        print(f"drift {rate}: {wrong_percent(occupied):.1f} % wrong")
