# style: a generator

import numpy as np


def walk():
    n = max(abs(last[0] - column), abs(last[1] - row))
    for k in range(n + 1):
        t = k / n if n else 0
        yield round(column + t * (last[0] - column)), round(row + t * (last[1] - row))


cells = list(walk())
