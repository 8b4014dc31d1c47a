# style: floats from NumPy

import numpy as np


def hits_needed(l, l_occ):
    return np.maximum(0, np.floor((KNOWN - l) / l_occ) + 1)
