"""hits_needed(l, l_occ): hits until a cell is called occupied."""

from math import ceil, floor

from grader import calls, check, function, lacks, mistake, near, number, reads

KNOWN = 1


def hits(l, l_occ, known=KNOWN):
    count = 0
    while l <= known:
        l, count = l + l_occ, count + 1
    return count


def log_odds_reached(l, l_occ):
    return l + hits(l, l_occ) * l_occ


STOPS_AT_0 = "it stops at 0, where the map has no idea: occupied begins above KNOWN"
NEVER_BELOW_0 = "a cell that is occupied already needs 0 hits, not a negative number of hits"

hits_needed = function(
    "hits_needed(l, l_occ)",
    hits,
    compare=near(1e-6),  # 2.0 hits are 2 hits
    mistakes=[
        (
            "one hit short: part of a hit can't be had, so count up to the next whole one",
            lambda l, l_occ: max(0, floor((KNOWN - l) / l_occ)),
            1,
        ),
        (
            "at exactly KNOWN the cell is not occupied yet: it must be above",
            lambda l, l_occ: max(0, ceil((KNOWN - l) / l_occ)),
            2,
        ),
        mistake(
            "math.ceil() gives one hit too few where the sum comes to exactly KNOWN, and less than "
            "0 for a cell that is occupied already",
            lambda l, l_occ: ceil((KNOWN - l) / l_occ),
            2,
            where=calls("ceil"),
        ),
        (STOPS_AT_0, lambda l, l_occ: max(0, ceil(-l / l_occ)), 0),
        (STOPS_AT_0, lambda l, l_occ: max(0, floor(-l / l_occ) + 1), 0),
        (
            "it counts from 0 and not from l: the cell may be far below 0, or above it",
            lambda l, l_occ: floor(KNOWN / l_occ) + 1,
            0,
        ),
        (NEVER_BELOW_0, lambda l, l_occ: floor((KNOWN - l) / l_occ) + 1, 2),
        (NEVER_BELOW_0, lambda l, l_occ: int((KNOWN - l) / l_occ) + 1, 2),
        mistake(
            "a cell that is occupied already needs 0 hits: abs() makes some of it",
            lambda l, l_occ: floor(abs(KNOWN - l) / l_occ) + 1,
            2,
            where=calls("abs"),
        ),
        (
            "hits come in whole numbers: count up to the next whole one",
            lambda l, l_occ: (KNOWN - l) / l_occ,
            1,
        ),
        (
            "rounded to the nearest: half a hit is not enough, so it is always the next whole one",
            lambda l, l_occ: max(0, round((KNOWN - l) / l_occ)),
            1,
        ),
        (
            "one hit too many: stop as soon as the log odds are above KNOWN",
            lambda l, l_occ: hits(l, l_occ) + 1,
            2,
        ),
        (
            "those are the log odds that the cell reaches: return how many hits it took",
            log_odds_reached,
            1,
        ),
        (
            "at most one hit is counted: the loop has to go on until l is above KNOWN (a while, "
            "not an if, and the return after it)",
            lambda l, l_occ: min(1, hits(l, l_occ)),
            1,
        ),
        mistake(
            "0.85 was added whatever l_occ is: use the parameter l_occ",
            lambda l, l_occ: hits(l, 0.85),
            1,
            where=number(0.85),
        ),
        (
            "it goes on up to the clamp: the cell is occupied as soon as its log odds are above "
            "KNOWN",
            lambda l, l_occ: max(0, ceil((8 - l) / l_occ)),
            0,
        ),
        (
            "it stops at -KNOWN, where the cell is no longer free: occupied begins above KNOWN",
            lambda l, l_occ: hits(l, l_occ, -KNOWN),
            0,
        ),
    ],
)

KNOWN_2_5 = function(
    "hits_needed(l, l_occ)",
    lambda l, l_occ: hits(l, l_occ, 2.5),
    compare=near(1e-6),
    mistakes=[
        mistake(
            "1 is typed in: use KNOWN, so that it can change",
            hits,
            2,
            where=(number(1), lacks(reads("KNOWN"))),
        )
    ],
)


@check("A cell nobody has looked at", hint=0)
def unknown(task):
    task.call(hits_needed, 0, 0.85, gives=2)
    task.call(hits_needed, 0, 2, gives=1)


@check("A cell that is as free as can be", hint=1)
def free(task):
    task.call(hits_needed, -8, 0.85, gives=11)
    task.call(hits_needed, -8, 0.4, gives=23)
    task.call(hits_needed, -8, 0.0625, gives=145)


@check("Exactly at KNOWN is not above it", hint=2)
def edge(task):
    task.call(hits_needed, 0.5, 0.5, gives=2)
    task.call(hits_needed, -8, 0.5, gives=19)
    task.call(hits_needed, 1, 0.5, gives=1)


@check("A cell that is occupied already", hint=2)
def already(task):
    task.call(hits_needed, 3, 0.85, gives=0)
    task.call(hits_needed, 8, 0.5, gives=0)


@check("Any cell", hint=1)
def any_cell(task):
    for l_occ in (0.25, 0.5, 0.75, 1.5):
        for _ in range(3):
            task.call(hits_needed, task.random.randrange(-320, 40) / 40 + 0.0125, l_occ)


@check("With KNOWN at 2.5", hint=2)
def another_known(task):
    task.set("KNOWN", 2.5)
    task.call(KNOWN_2_5, 0, 0.85, gives=3)
    task.call(KNOWN_2_5, -8, 0.85, gives=13)
    task.call(KNOWN_2_5, 2, 0.5, gives=2)
