# earns: the sum was clamped
# Fuse a list of readings
#
# Each reading is a probability: how likely this one
# reading makes it that something stands in the cell.
# The chart shows what your function makes of the first
# reading, of the first two, the first three...

from bugbot import *
import math


# ---- your part ----
def fuse(readings):
    l = 0.0
    for p in readings:
        l = max(-8, min(8, l + log_odds(p)))
    return probability(l)


# ---- end of your part ----


# log_odds and probability are for you to use.
def log_odds(p):
    """The log odds of a probability p between 0 and 1."""
    return math.log(p / (1 - p))


def probability(l):
    """The probability that belongs to the log odds l."""
    return 1 / (1 + math.exp(-l))


READINGS = [0.7, 0.7, 0.4, 0.7, 0.4, 0.4, 0.4, 0.7, 0.7, 0.7]

for n in range(len(READINGS) + 1):
    p = fuse(READINGS[:n])
    plot("fused", p)
    if n > 0:
        plot("this reading", READINGS[n - 1])
    height = 200 * max(0, min(1, p))  # 1 is the top of the mat
    draw("how likely", [(100, 0), (100, height)], "black", "line", 20)
    print(f"after {n} readings: {p}")
    wait(1)
