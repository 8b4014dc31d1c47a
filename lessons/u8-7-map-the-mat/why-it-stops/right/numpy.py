# style: NumPy arrays with inf for no way
import numpy as np


def reason(seconds, driven, regions, ways):
    sizes = np.array(regions, float)
    lengths = np.array([np.inf if way is None else way for way in ways])
    lengths = lengths[sizes >= MIN_REGION]
    if seconds >= MAX_TIME:
        return "time is up"
    if sizes.size == 0:
        return "no frontier is left"
    if lengths.size == 0:
        return "only small frontiers are left"
    if np.isinf(lengths).all():
        return "no frontier can be reached"
    if (driven + lengths > MAX_WAY).all():
        return "the rest is too far"
