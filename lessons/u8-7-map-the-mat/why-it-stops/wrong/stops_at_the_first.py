# earns: it stops as soon as one region can't be reached or is too far
# Why it stops
#
# An explorer must come to an end, and say why. These are
# the questions, in this order. The first that is answered
# with yes is the reason.

from bugbot import *

MIN_REGION = 4  # frontier regions of fewer cells are left out
MAX_TIME = 200  # s
MAX_WAY = 1600  # cm


# ---- your part ----
def reason(seconds, driven, regions, ways):
    if seconds >= MAX_TIME:
        return "time is up"
    if len(regions) == 0:
        return "no frontier is left"
    big = [i for i in range(len(regions)) if regions[i] >= MIN_REGION]
    if len(big) == 0:
        return "only small frontiers are left"
    for i in big:
        if ways[i] is None:
            return "no frontier can be reached"
    for i in big:
        if driven + ways[i] > MAX_WAY:
            return "the rest is too far"
    return None


# ---- end of your part ----


# The rest is done: five robots at five moments.
print(reason(200, 500, [12], [90]))
print(reason(60, 500, [], []))
print(reason(60, 500, [3, 1], [30, 80]))
print(reason(60, 500, [3, 9], [30, None]))
print(reason(60, 1550, [3, 9, 20], [30, 90, 140]))
print(reason(60, 1500, [3, 9, 20], [30, 90, 140]))
