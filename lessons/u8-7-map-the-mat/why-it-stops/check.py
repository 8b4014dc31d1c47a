"""reason(seconds, driven, regions, ways): why an explorer stops, or None."""

from grader import check, code, function, lacks, mistake

LEAST, TIME, WAY = 4, 200, 1600


def by(
    time=lambda seconds: seconds >= TIME,
    large=lambda size: size >= LEAST,
    small=None,
    reached=None,
    unreachable=None,
    over=None,
):
    """What is right, or a slip of it in one of its questions."""

    def answer(seconds, driven, regions, ways):
        if time(seconds):
            return "time is up"
        if not regions:
            return "no frontier is left"
        worth = [way for size, way in zip(regions, ways, strict=True) if large(size)]
        if small(regions) if small else not worth:
            return "only small frontiers are left"
        lengths = (reached or found)(worth, ways)
        if unreachable(worth) if unreachable else not lengths:
            return "no frontier can be reached"
        if (over or beyond)(driven, lengths):
            return "the rest is too far"
        return None

    return answer


def found(worth, _ways):
    return [way for way in worth if way is not None]


def beyond(driven, lengths):
    return driven + min(lengths) > WAY


def other_order(seconds, driven, regions, ways):
    return by()(seconds, driven, regions, ways) if regions else "no frontier is left"


reason = function(
    "reason(seconds, driven, regions, ways)",
    by(),
    leaves=True,
    mistakes=[
        (
            "one region that is too small is enough to stop: all of them must be",
            by(small=lambda regions: min(regions) < LEAST),
            1,
        ),
        (
            "the way to a region that is too small counts: leave such regions out first",
            by(reached=lambda _worth, ways: [way for way in ways if way is not None]),
            1,
        ),
        (
            "the farthest region decides: as long as one can be afforded, go on",
            by(over=lambda driven, lengths: driven + max(lengths) > WAY),
            2,
        ),
        (
            "one region that can't be reached is enough to stop: another one may be",
            by(unreachable=lambda worth: None in worth),
            1,
        ),
        mistake(
            "a way of 0 cm looks taken for none: ask `is not None`",
            by(reached=lambda worth, _ways: [way for way in worth if way]),
            2,
            where=lacks(code("_ is not None")),
        ),
        (
            "at MAX_TIME itself the time is up as well, not only after it",
            by(time=lambda seconds: seconds > TIME),
            0,
        ),
        (
            "a way that comes to exactly MAX_WAY can be afforded: only beyond it is too far",
            by(over=lambda driven, lengths: driven + min(lengths) >= WAY),
            2,
        ),
        (
            "what has been driven so far is left out: it counts, too",
            by(over=lambda _driven, lengths: min(lengths) > WAY),
            2,
        ),
        (
            "a region of exactly MIN_REGION cells is large enough",
            by(large=lambda size: size > LEAST),
            1,
        ),
        ("the order of the questions: time comes first", other_order, 0),
    ],
)


OTHER_LIMITS = function(
    "reason(seconds, driven, regions, ways)",
    by(
        large=lambda size: size >= 6,
        over=lambda driven, lengths: driven + min(lengths) > 700,
        time=lambda seconds: seconds >= 90,
    ),
    leaves=True,
    mistakes=[
        (
            f"{words} was typed in: {name} says it",
            by(
                large=lambda size, least=least: size >= least,
                over=lambda driven, lengths, way=way: driven + min(lengths) > way,
                time=lambda seconds, longest=longest: seconds >= longest,
            ),
            0,
        )
        for words, name, least, way, longest in (
            (LEAST, "MIN_REGION", LEAST, 700, 90),
            (TIME, "MAX_TIME", 6, 700, TIME),
            (WAY, "MAX_WAY", 6, WAY, 90),
        )
    ],
)


@check("Time is up, or nothing is left", hint=0)
def plain(task):
    task.call(reason, 200, 500, [12], [90], gives="time is up")
    task.call(reason, 230, 500, [], [], gives="time is up")
    task.call(reason, 60, 500, [], [], gives="no frontier is left")


@check("Only small ones", hint=1)
def small(task):
    task.call(reason, 60, 500, [3, 1], [30, 80], gives="only small frontiers are left")
    task.call(reason, 60, 500, [3, 12], [30, 80], gives=None)
    task.call(reason, 60, 500, [4], [30], gives=None)


@check("Out of reach", hint=1)
def reach(task):
    task.call(reason, 60, 500, [3, 9], [30, None], gives="no frontier can be reached")
    task.call(reason, 60, 500, [8, 9], [None, 70], gives=None)
    task.call(reason, 60, 500, [8], [0], gives=None)


@check("Too far", hint=2)
def far(task):
    task.call(reason, 60, 1550, [3, 9, 20], [30, 90, 140], gives="the rest is too far")
    task.call(reason, 60, 1480, [9, 20], [90, 140], gives=None)
    task.call(reason, 60, 1510, [9], [90], gives=None)


@check("Many moments", hint=2)
def many(task):
    for _ in range(40):
        count = task.random.randrange(4)
        sizes = [task.random.randrange(1, 9) for _ in range(count)]
        ways = [task.random.choice([None, 0, 40, 90, 200, 400]) for _ in range(count)]
        seconds, driven = task.random.randrange(20, 210), task.random.randrange(0, 1600)
        task.call(reason, seconds, driven, sizes, ways)


@check("Other limits", hint=2)
def other_limits(task):
    task.set("MIN_REGION", 6)
    task.set("MAX_TIME", 90)
    task.set("MAX_WAY", 700)
    task.call(OTHER_LIMITS, 90, 100, [9], [50], gives="time is up")
    task.call(OTHER_LIMITS, 89, 100, [5, 4], [50, 50], gives="only small frontiers are left")
    task.call(OTHER_LIMITS, 60, 650, [6], [51], gives="the rest is too far")
    task.call(OTHER_LIMITS, 60, 650, [6], [50], gives=None)
