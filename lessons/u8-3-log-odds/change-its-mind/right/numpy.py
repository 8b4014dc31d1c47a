# style: NumPy

import numpy as np


def hits_needed(l, l_occ):
    hits = np.arange(1000)
    return np.argmax(l + hits * l_occ > KNOWN)
