"""find_room(free): the cells on whose middle the robot has room."""

from grader import check, function
from mapping.frontiers import State
from mapping.grid import Grid
from mapping.planning import room_cells

MAT = Grid(5)
CELLS = {MAT.cell(index) for index in range(len(MAT.cells))}
SIDES = [(0, 0), (-1, 0), (1, 0), (0, -1), (0, 1)]
AROUND = [(c, r) for c in (-1, 0, 1) for r in (-1, 0, 1)]


def reference(spare):
    def find_room(free):
        states = [
            State.FREE if MAT.cell(index) in free else State.UNKNOWN
            for index in range(len(MAT.cells))
        ]
        return {MAT.cell(index) for index in room_cells(MAT, states, spare)}

    return find_room


def with_free(free, steps, cells):
    return {(c, r) for c, r in cells if all((c + i, r + j) in free for i, j in steps)}


def edge_is_open(free):
    return {
        (c, r)
        for c, r in free
        if all((c + i, r + j) in free or (c + i, r + j) not in CELLS for i, j in AROUND)
    }


def of(spare, more=()):
    return function("find_room(free)", reference(spare), cell_cm=5, mistakes=list(more))


find_room = of(
    6,
    [
        (
            "only the four sides look counted: a cell at a corner is 7.1 cm away, "
            "nearer than SPARE + CELL / 2",
            lambda free: with_free(free, SIDES, free),
            0,
        ),
        (
            "cells beyond the mat look counted as free: there is the wall round the mat",
            edge_is_open,
            1,
        ),
        (
            "two cells to each side look kept clear: 10 cm is more than SPARE + CELL / 2",
            reference(9),
            0,
        ),
        (
            "these are the cells without room",
            lambda free: free - reference(6)(free),
            2,
        ),
    ],
)
SLIPS_OF_OTHERS = [
    (
        "SPARE looks typed in: work out from SPARE and CELL which cells are too near",
        reference(6),
        1,
    )
]
wide, slim = of(11, SLIPS_OF_OTHERS), of(2, SLIPS_OF_OTHERS)


def some_floor(task):
    free = set(CELLS)
    for _ in range(12):
        column, row = task.random.randrange(38), task.random.randrange(38)
        free -= {(column + i, row + j) for i in range(2) for j in range(2)}
    return free


@check("A passage three cells wide", hint=0)
def passage(task):
    free = {(column, row) for column in (10, 11, 12) for row in range(5, 30)}
    task.call(find_room, free, gives={(11, row) for row in range(6, 29)})


@check("An empty mat", hint=1)
def empty(task):
    task.call(find_room, CELLS)


@check("Boxes all about", hint=2)
def boxes(task):
    for _ in range(3):
        task.call(find_room, some_floor(task))


@check("Robots of other sizes", hint=2)
def sizes(task):
    task.set("SPARE", 11)
    task.call(wide, some_floor(task))
    task.set("SPARE", 2)
    task.call(slim, some_floor(task))
