# earns: rounded up
from math import ceil


def steps(length, step):
    return ceil(length / step)
