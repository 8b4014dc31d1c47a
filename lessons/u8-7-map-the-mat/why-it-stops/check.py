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


def time_second(seconds, driven, regions, ways):
    return by()(seconds, driven, regions, ways) if regions else "no frontier is left"


def way_second(seconds, driven, regions, ways):
    right = by()(seconds, driven, regions, ways)
    return "the rest is too far" if driven > WAY and right != "time is up" else right


def reach_before_size(seconds, driven, regions, ways, dropped=False):
    """With dropped, regions that can't be reached are left out for the questions after it."""
    pairs = [(size, way) for size, way in zip(regions, ways, strict=True) if way is not None]
    if dropped or not pairs:
        right = by()(seconds, driven, [size for size, _ in pairs], [way for _, way in pairs])
        none = regions and right == "no frontier is left"
        return "no frontier can be reached" if none else right
    return by()(seconds, driven, regions, ways)


def one_of_each_size(seconds, driven, regions, ways):
    last = dict(zip(regions, ways, strict=True))
    return by()(seconds, driven, list(last), list(last.values()))


def with_capital(which, none):
    """The right words but for a capital letter, in one of the reasons or in all of them."""

    def answer(*asked):
        right = by()(*asked)
        return none if right is None else right.capitalize() if right in which else right

    return answer


WORDS = (
    "time is up",
    "no frontier is left",
    "only small frontiers are left",
    "no frontier can be reached",
    "the rest is too far",
)


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
            "the way to a region that is too small is counted, too: leave such regions out first",
            by(reached=lambda _worth, ways: [way for way in ways if way is not None]),
            1,
        ),
        (
            "the farthest region decides: as long as one can be afforded, go on",
            by(over=lambda driven, lengths: driven + max(lengths) > WAY),
            2,
        ),
        (
            "it stops as soon as one region can't be reached; another one may still be reachable",
            by(unreachable=lambda worth: None in worth),
            1,
        ),
        (
            "it stops as soon as one region can't be reached or is too far; "
            "another one may still be within reach",
            by(
                unreachable=lambda worth: None in worth,
                over=lambda driven, lengths: driven + max(lengths) > WAY,
            ),
            1,
        ),
        (
            "only the first region that is large enough is asked: go through all of them",
            by(reached=lambda worth, ways: found(worth[:1], ways)),
            1,
        ),
        (
            "of regions of one size only the last counts: each has a way of its own",
            one_of_each_size,
            1,
        ),
        mistake(
            "a way of 0 cm is taken for no way at all: ask `is not None`",
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
            "with exactly MAX_WAY driven a way of 0 cm can be afforded: only more is too far",
            by(over=lambda driven, lengths: driven >= WAY or beyond(driven, lengths)),
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
        ("the order of the questions: time comes first", time_second, 0),
        ("the order of the questions: whether the rest is too far comes last", way_second, 0),
        *(
            (
                "the order of the questions: whether all are small comes before the way there",
                lambda *asked, dropped=dropped: reach_before_size(*asked, dropped),
                0,
            )
            for dropped in (False, True)
        ),
        (
            '"None" in quotes is a text: return None without them',
            with_capital((), none="None"),
            0,
        ),
        *(
            ("only a capital letter differs: copy the words as they are", answer, 0)
            for none in (None, "None")
            for which in (WORDS, *((words,) for words in WORDS))
            for answer in [with_capital(which, none)]
        ),
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
    task.call(reason, 60, 500, [3, 1], [None, None], gives="only small frontiers are left")
    task.call(reason, 60, 500, [3, 12], [30, 80], gives=None)
    task.call(reason, 60, 500, [4], [30], gives=None)


@check("Out of reach", hint=1)
def reach(task):
    task.call(reason, 60, 500, [3, 9], [30, None], gives="no frontier can be reached")
    task.call(reason, 60, 500, [8, 9], [None, 70], gives=None)
    task.call(reason, 60, 500, [8], [0], gives=None)
    task.call(reason, 60, 500, [9, 9], [70, None], gives=None)
    task.call(reason, 60, 500, [9, 9], [None, 70], gives=None)


@check("Too far", hint=2)
def far(task):
    task.call(reason, 60, 1550, [3, 9, 20], [30, 90, 140], gives="the rest is too far")
    task.call(reason, 60, 1480, [9, 20], [90, 140], gives=None)
    task.call(reason, 60, 1510, [9], [90], gives=None)
    task.call(reason, 60, 1600, [9], [0], gives=None)
    task.call(reason, 60, 1601, [9], [0], gives="the rest is too far")


@check("Too far, and another reason before it", hint=0)
def too_far_already(task):
    task.call(reason, 200, 1700, [9], [90], gives="time is up")
    task.call(reason, 60, 1700, [], [], gives="no frontier is left")
    task.call(reason, 60, 1700, [2], [30], gives="only small frontiers are left")
    task.call(reason, 60, 1700, [9], [None], gives="no frontier can be reached")


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
