# style: NumPy

import numpy as np


def add(l, evidence, limit):
    return np.clip(l + evidence, -limit, limit)
