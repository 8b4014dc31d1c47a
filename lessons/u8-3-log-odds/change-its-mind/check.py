"""hits_needed(l, l_occ): hits until a cell is called occupied."""

from math import ceil, floor

from grader import check, function

KNOWN = 1


def hits(l, l_occ):
    count = 0
    while l <= KNOWN:
        l, count = l + l_occ, count + 1
    return count


hits_needed = function(
    "hits_needed(l, l_occ)",
    hits,
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
        (
            "it stops at 0, where the map has no idea: occupied begins above KNOWN",
            lambda l, l_occ: max(0, ceil(-l / l_occ)),
            0,
        ),
        (
            "it stops at 0, where the map has no idea: occupied begins above KNOWN",
            lambda l, l_occ: max(0, floor(-l / l_occ) + 1),
            0,
        ),
        (
            "it counts from 0 and not from l: the cell may be far below 0, or above it",
            lambda l, l_occ: floor(KNOWN / l_occ) + 1,
            0,
        ),
        (
            "a cell that is occupied already needs 0 hits, not a negative number of hits",
            lambda l, l_occ: floor((KNOWN - l) / l_occ) + 1,
            2,
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
    task.call(hits_needed, -100, 0.85)


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
    for _ in range(8):
        task.call(hits_needed, task.random.randrange(-320, 40) / 40 + 0.0125, 0.75)
