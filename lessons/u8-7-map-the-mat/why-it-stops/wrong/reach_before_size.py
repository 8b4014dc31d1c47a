# earns: whether all are small comes before the way there
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
    reachable = [(size, way) for size, way in zip(regions, ways) if way is not None]
    if not reachable:
        return "no frontier can be reached"
    large = [way for size, way in reachable if size >= MIN_REGION]
    if not large:
        return "only small frontiers are left"
    if driven + min(large) > MAX_WAY:
        return "the rest is too far"


# ---- end of your part ----


# The rest is done: five robots at five moments.
print(reason(200, 500, [12], [90]))
print(reason(60, 500, [], []))
print(reason(60, 500, [3, 1], [30, 80]))
print(reason(60, 500, [3, 9], [30, None]))
print(reason(60, 1550, [3, 9, 20], [30, 90, 140]))
print(reason(60, 1500, [3, 9, 20], [30, 90, 140]))
