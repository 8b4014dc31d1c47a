# earns: only the first region that is large enough
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
    if not regions:
        return "no frontier is left"
    if max(regions) < MIN_REGION:
        return "only small frontiers are left"
    for size, way in zip(regions, ways):
        if size < MIN_REGION:
            continue
        if way is None:
            return "no frontier can be reached"
        if driven + way > MAX_WAY:
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
