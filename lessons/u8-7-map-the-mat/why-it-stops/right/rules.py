# style: a list of questions as lambdas, the first yes wins
def reason(seconds, driven, regions, ways):
    pairs = list(zip(regions, ways))
    large = [pair for pair in pairs if pair[0] >= MIN_REGION]
    reachable = [way for _, way in large if way is not None]
    questions = [
        ("time is up", lambda: seconds >= MAX_TIME),
        ("no frontier is left", lambda: len(pairs) == 0),
        ("only small frontiers are left", lambda: not large),
        ("no frontier can be reached", lambda: not reachable),
        ("the rest is too far", lambda: all(driven + way > MAX_WAY for way in reachable)),
    ]
    return next((words for words, true in questions if true()), None)
