"""add(l, evidence, limit): add, then clamp."""

from grader import calls, check, either, function, mistake, near, number, operator, reads


def kept(l, limit):
    return max(-limit, min(limit, l))


def right(l, evidence, limit):
    return kept(l + evidence, limit)


def beyond(answer):
    """What a mistake answers that has `answer(l, total, limit)` for a sum past the limit."""

    def add(l, evidence, limit):
        total = l + evidence
        return total if -limit <= total <= limit else answer(l, total, limit)

    return add


def nothing_if(silent):
    """What a mistake answers that has no answer for a sum of which `silent(total, limit)` holds."""

    def add(l, evidence, limit):
        return None if silent(l + evidence, limit) else right(l, evidence, limit)

    return add


def stays(l, evidence, limit):
    return kept(l, limit) if abs(l) >= limit else right(l, evidence, limit)


def one_side(l, evidence, limit):
    return min(limit, l + evidence) if evidence > 0 else max(-limit, l + evidence)


CHANGED_PLACES = (
    "min and max have changed places: min(limit, ...) holds the top, max(-limit, ...) the bottom"
)
OWN_LIMIT = (
    "the limit is 8 here, whatever the function is told: use its parameter `limit`, not 8 and not "
    "L_MAX"
)
WHOSE_SIGN = (
    "which of the two limits it is depends on the sum: one above limit becomes limit, one below "
    "-limit becomes -limit, whatever the sign of l or of the evidence"
)
NOTHING_AT_THE_LIMIT = (
    "a sum that is exactly at a limit gets no answer: with <= and >= (or a plain else) every sum "
    "has one"
)
ROUNDED = "the answer was rounded: return it with all its decimals"

add = function(
    "add(l, evidence, limit)",
    right,
    compare=near(0.0001),
    mistakes=[
        (
            "what comes back is not clamped: return what max() and min() give, between -limit and "
            "limit",
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
            "l is clamped before the evidence is added, so the sum can still pass the limit: add "
            "first",
            lambda l, evidence, limit: kept(l, limit) + evidence,
            0,
        ),
        mistake(
            CHANGED_PLACES,
            lambda l, evidence, limit: max(limit, min(-limit, l + evidence)),
            2,
            where=(calls("min"), calls("max")),
        ),
        mistake(
            CHANGED_PLACES,
            lambda l, evidence, limit: min(-limit, max(limit, l + evidence)),
            2,
            where=(calls("min"), calls("max")),
        ),
        (
            "the two limits have changed places: above limit the answer is limit, below -limit "
            "it is -limit",
            beyond(lambda l, total, limit: -limit if total > 0 else limit),
            2,
        ),
        mistake(
            OWN_LIMIT,
            lambda l, evidence, limit: kept(l + evidence, 8),
            1,
            where=either(number(8), reads("L_MAX")),
        ),
        mistake(
            OWN_LIMIT,
            lambda l, evidence, limit: max(-8, min(limit, l + evidence)),
            1,
            where=either(number(8), reads("L_MAX")),
        ),
        mistake(
            OWN_LIMIT,
            lambda l, evidence, limit: max(-limit, min(8, l + evidence)),
            1,
            where=either(number(8), reads("L_MAX")),
        ),
        (
            "evidence past the limit is thrown away: the sum should come to rest on the limit",
            beyond(lambda l, total, limit: l),
            0,
        ),
        (
            "past the limit it goes back to 0: the sum should come to rest on the limit",
            beyond(lambda l, total, limit: 0),
            0,
        ),
        (
            "the bottom is 0 here: free floor goes below 0, down to -limit",
            lambda l, evidence, limit: max(0, min(limit, l + evidence)),
            1,
        ),
        mistake(
            "the sign is lost: below -limit the answer is -limit, and abs() makes limit of it",
            lambda l, evidence, limit: min(limit, abs(l + evidence)),
            1,
            where=calls("abs"),
        ),
        (
            "the evidence is missing: clamp l + evidence, not l",
            lambda l, evidence, limit: kept(l, limit),
            0,
        ),
        (
            "the evidence was subtracted: it has its own sign already, so add it",
            lambda l, evidence, limit: kept(l - evidence, limit),
            0,
        ),
        mistake(
            "l and evidence were multiplied: evidence is added",
            lambda l, evidence, limit: kept(l * evidence, limit),
            0,
            where=operator("*"),
        ),
        mistake(
            "L_OCC was added, whatever the evidence is: use the parameter `evidence`",
            lambda l, evidence, limit: kept(l + 0.85, limit),
            0,
            where=reads("L_OCC"),
        ),
        (
            "within the limits nothing comes back: the sum itself has to be returned there",
            nothing_if(lambda total, limit: -limit <= total <= limit),
            0,
        ),
        (NOTHING_AT_THE_LIMIT, nothing_if(lambda total, limit: abs(total) == limit), 1),
        (NOTHING_AT_THE_LIMIT, nothing_if(lambda total, limit: total == limit), 1),
        (NOTHING_AT_THE_LIMIT, nothing_if(lambda total, limit: total == -limit), 1),
        (
            "once l is at the limit it stays there: evidence still counts there, and can bring it "
            "back",
            stays,
            0,
        ),
        (
            "l is clamped before the evidence is added: add the evidence to l as it is, and clamp "
            "only the sum",
            lambda l, evidence, limit: kept(kept(l, limit) + evidence, limit),
            0,
        ),
        (
            "only one limit is asked about, the one that the evidence leads towards: l may be "
            "beyond the other to begin with, so hold the sum at both",
            one_side,
            1,
        ),
        (
            "below -limit the answer is limit here: a sum below -limit becomes -limit",
            beyond(lambda l, total, limit: limit),
            1,
        ),
        (WHOSE_SIGN, beyond(lambda l, total, limit: limit if l > 0 else -limit), 1),
        (WHOSE_SIGN, beyond(lambda l, total, limit: limit if l >= 0 else -limit), 1),
        (WHOSE_SIGN, beyond(lambda l, total, limit: limit if total > l else -limit), 1),
        (ROUNDED, lambda l, evidence, limit: round(right(l, evidence, limit), 3), 2),
        (ROUNDED, lambda l, evidence, limit: round(right(l, evidence, limit), 2), 2),
        (ROUNDED, lambda l, evidence, limit: round(right(l, evidence, limit), 1), 2),
        (ROUNDED, lambda l, evidence, limit: round(right(l, evidence, limit)), 2),
        (ROUNDED, lambda l, evidence, limit: int(right(l, evidence, limit)), 2),
    ],
)


@check("Far from the clamp it just adds", hint=0)
def free(task):
    task.call(add, 0, 0.85, 8, gives=0.85)
    task.call(add, 0.85, -0.4, 8, gives=0.45)
    task.call(add, -3.2, 0.85, 8, gives=-2.35)
    task.call(add, 0, 0.8473, 8, gives=0.8473)


@check("Never above the limit", hint=1)
def top(task):
    task.call(add, 7.5, 0.85, 8, gives=8)
    task.call(add, 8, 0.85, 8, gives=8)
    task.call(add, 7.25, 0.75, 8, gives=8)


@check("Never below minus the limit", hint=1)
def bottom(task):
    task.call(add, -7.8, -0.4, 8, gives=-8)
    task.call(add, -8, -0.4, 8, gives=-8)
    task.call(add, -7.25, -0.75, 8, gives=-8)


@check("Back from the limit at once", hint=0)
def back(task):
    task.call(add, 8, -0.4, 8, gives=7.6)
    task.call(add, -8, 0.85, 8, gives=-7.15)


@check("From one side to the other", hint=1)
def across(task):
    task.call(add, -0.5, 2.75, 2, gives=2)
    task.call(add, 0.5, -2.75, 2, gives=-2)
    task.call(add, 0, 2.5, 2, gives=2)
    task.call(add, 0, -2.5, 2, gives=-2)


@check("Another limit", hint=2)
def other(task):
    for limit in (2, 3.5, 100):
        for _ in range(4):
            l = round(task.random.uniform(-limit, limit), 2)
            task.call(add, l, task.random.choice((0.85, -0.4, 2.5)), limit)
    task.call(add, 1.9, 0.85, 2, gives=2)
    task.call(add, -1.9, -0.4, 2, gives=-2)
    task.call(add, 9, -0.4, 2, gives=2)
    task.call(add, 99, 0.85, 100, gives=99.85)
    task.call(add, -99, -0.4, 100, gives=-99.4)
