# style: a text enum and a match statement over the nearest way
from enum import StrEnum


class Why(StrEnum):
    TIME = "time is up"
    NONE = "no frontier is left"
    SMALL = "only small frontiers are left"
    CLOSED = "no frontier can be reached"
    FAR = "the rest is too far"


def reason(seconds, driven, regions, ways):
    worth = dict(enumerate(ways))
    for i, size in enumerate(regions):
        if size < MIN_REGION:
            del worth[i]
    nearest = min((way for way in worth.values() if way is not None), default=None)
    match (seconds < MAX_TIME, len(regions), len(worth), nearest):
        case (False, _, _, _):
            return Why.TIME
        case (_, 0, _, _):
            return Why.NONE
        case (_, _, 0, _):
            return Why.SMALL
        case (_, _, _, None):
            return Why.CLOSED
        case (_, _, _, way) if way + driven > MAX_WAY:
            return Why.FAR
    return None
