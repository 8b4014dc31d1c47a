"""add(l, evidence, limit): add, then clamp."""

from grader import check, function, near


def kept(l, limit):
    return max(-limit, min(limit, l))


add = function(
    "add(l, evidence, limit)",
    lambda l, evidence, limit: kept(l + evidence, limit),
    compare=near(0.0001),
    mistakes=[
        (
            "there is no clamp yet: the sum must stay between -limit and limit",
            lambda l, evidence, limit: l + evidence,
            0,
        ),
        (
            "it is clamped only at the top: free floor needs a limit too, at -limit",
            lambda l, evidence, limit: min(limit, l + evidence),
            1,
        ),
        (
            "it is clamped only at the bottom: walls need a limit too, at limit",
            lambda l, evidence, limit: max(-limit, l + evidence),
            1,
        ),
        (
            "the evidence is clamped and not the sum: add first, then clamp what comes out",
            lambda l, evidence, limit: l + kept(evidence, limit),
            0,
        ),
        (
            "l is clamped before the evidence is added, so the "
            "sum can still pass the limit: add first",
            lambda l, evidence, limit: kept(l, limit) + evidence,
            0,
        ),
        (
            "min and max have changed places: min(limit, ...) "
            "holds the top, max(-limit, ...) the bottom",
            lambda l, evidence, limit: max(limit, min(-limit, l + evidence)),
            2,
        ),
        (
            "min and max have changed places: min(limit, ...) "
            "holds the top, max(-limit, ...) the bottom",
            lambda l, evidence, limit: min(-limit, max(limit, l + evidence)),
            2,
        ),
        (
            "8 is typed in: use the limit that the function is given",
            lambda l, evidence, limit: kept(l + evidence, 8),
            1,
        ),
        (
            "evidence past the limit is thrown away: the sum should come to rest on the limit",
            lambda l, evidence, limit: l + evidence if -limit <= l + evidence <= limit else l,
            0,
        ),
        (
            "the evidence is missing: clamp l + evidence, not l",
            lambda l, evidence, limit: kept(l, limit),
            0,
        ),
    ],
)


@check("Far from the clamp it just adds", hint=0)
def free(task):
    task.call(add, 0, 0.85, 8, gives=0.85)
    task.call(add, 0.85, -0.4, 8, gives=0.45)


@check("Never above the limit", hint=1)
def top(task):
    task.call(add, 7.5, 0.85, 8, gives=8)
    task.call(add, 8, 0.85, 8, gives=8)


@check("Never below minus the limit", hint=1)
def bottom(task):
    task.call(add, -7.8, -0.4, 8, gives=-8)
    task.call(add, -8, -0.4, 8, gives=-8)


@check("Back from the limit at once", hint=0)
def back(task):
    task.call(add, 8, -0.4, 8, gives=7.6)
    task.call(add, -8, 0.85, 8, gives=-7.15)


@check("Another limit", hint=2)
def other(task):
    for limit in (2, 3.5, 100):
        for _ in range(4):
            l = round(task.random.uniform(-limit, limit), 2)
            task.call(add, l, task.random.choice((0.85, -0.4, 2.5)), limit)
    task.call(add, 1.9, 0.85, 2, gives=2)
    task.call(add, 9, -0.4, 2, gives=2)
