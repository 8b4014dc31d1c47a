# earns: it stops as soon as one region can't be reached;
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
    """Why the robot stops, or None if it should go on.

    seconds, driven   what has gone by [s] and been driven [cm]
    regions           sizes of the frontier regions [cells]
    ways              to each region the length of the shortest
                      way there [cm], or None if
                      there is none

    "time is up"                   MAX_TIME is reached
    "no frontier is left"          there is no region at all
    "only small frontiers are left"   none has MIN_REGION cells
    "no frontier can be reached"   no way to any large enough
    "the rest is too far"          every way to those would
                                   take it beyond MAX_WAY
    """
    if seconds >= MAX_TIME:
        return "time is up"
    if not regions:
        return "no frontier is left"
    worth = [way for size, way in zip(regions, ways) if size >= MIN_REGION]
    if not worth:
        return "only small frontiers are left"
    lengths = [way for way in worth if way is not None]
    if None in worth:
        return "no frontier can be reached"
    if driven + min(lengths) > MAX_WAY:
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
