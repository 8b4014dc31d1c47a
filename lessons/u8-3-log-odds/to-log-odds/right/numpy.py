# style: NumPy

import numpy as np


def log_odds(p):
    return np.log(p / (1 - p))


def probability(l):
    return 1 / (1 + np.exp(-l))
