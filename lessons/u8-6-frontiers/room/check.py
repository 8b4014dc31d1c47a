"""find_room(free): the cells on whose middle the robot has room."""

from math import hypot

from grader import check, code, function, lacks, mistake, operator, reads
from mapping.frontiers import State
from mapping.grid import Grid
from mapping.planning import room_cells

CELLS = {(column, row) for column in range(40) for row in range(40)}
SIDES = [(0, 0), (-1, 0), (1, 0), (0, -1), (0, 1)]
AROUND = [(c, r) for c in (-1, 0, 1) for r in (-1, 0, 1)]


def reference(spare, cell=5):
    mat = Grid(cell)

    def find_room(free):
        states = [
            State.FREE if mat.cell(index) in free else State.UNKNOWN
            for index in range(len(mat.cells))
        ]
        return {mat.cell(index) for index in room_cells(mat, states, spare)}

    return find_room


def with_free(free, steps, cells):
    return {(c, r) for c, r in cells if all((c + i, r + j) in free for i, j in steps)}


def edge_is_open(free):
    return {
        (c, r)
        for c, r in free
        if all((c + i, r + j) in free or (c + i, r + j) not in CELLS for i, j in AROUND)
    }


def near_enough(far, cell=5, reach=4, gap=hypot):
    """The cells from which every cell nearer than far is free."""
    ways = range(-reach, reach + 1)
    steps = [(c, r) for c in ways for r in ways if gap(c, r) * cell < far]
    return lambda free: with_free(free, steps, free)


def to_side(c, r):
    """How far it is to the nearest side of the cell so many steps away."""
    return hypot(max(abs(c) - 0.5, 0), max(abs(r) - 0.5, 0))


def no_half(spare, cell=5):
    return mistake(
        "half a cell is left out: the limit is SPARE + CELL / 2",
        near_enough(spare, cell),
        0,
        where=code("_ < SPARE", "_ >= SPARE", "SPARE > _", "SPARE <= _", "_ = SPARE"),
    )


def of(spare, mistakes, cell=5):
    return function(
        "find_room(free)", reference(spare, cell), cell_cm=cell, mistakes=mistakes, leaves=True
    )


find_room = of(
    6,
    [
        no_half(6),
        (
            "a cell at a corner is 7.1 cm away, nearer than SPARE + CELL / 2: "
            "it has to be free, too",
            near_enough(6),
            0,
        ),
        (
            "cells off the mat were counted as free: there is the wall round the mat",
            edge_is_open,
            1,
        ),
        (
            "cells 10 cm away were kept clear too: that is more than SPARE + CELL / 2",
            near_enough(11.5),
            0,
        ),
        (
            "a square of five by five cells was kept clear: only cells nearer than "
            "SPARE + CELL / 2 count",
            near_enough(15),
            0,
        ),
        ("these are the cells without room", lambda free: free - reference(6)(free), 2),
        (
            "these are all the cells round which there is room: a cell has to be free itself",
            lambda free: with_free(free, [step for step in AROUND if any(step)], CELLS),
            2,
        ),
        ("these are all the free cells: not every one has room", lambda free: free, 0),
    ],
)


def others(spare, cell=5):
    """Another robot, or other cells."""
    return of(
        spare,
        [
            mistake(
                "SPARE was typed in: use its name, because other robots are larger",
                near_enough(6 + cell / 2, cell),
                1,
                where=(lacks(reads("SPARE")), reads("CELL")),
            ),
            mistake(
                "the steps were typed in: work out from SPARE and CELL which cells are too near",
                near_enough(8.5),
                1,
                where=lacks(reads("SPARE")),
            ),
            no_half(spare, cell),
            mistake(
                "CELL // 2 leaves out what comes after the point: half a cell is CELL / 2",
                near_enough(spare + cell // 2, cell),
                0,
                where=operator("//"),
            ),
            (
                "that is the gap to a cell's side: measure from middle to middle",
                near_enough(spare, cell, gap=to_side),
                1,
            ),
            (
                "only steps of up to two cells were tried: "
                "work out from SPARE and CELL how far they go",
                near_enough(spare + cell / 2, cell, reach=2),
                2,
            ),
            (
                "only the cells next to it were asked: a larger robot needs more of them clear",
                near_enough(min(spare + cell / 2, 1.5 * cell), cell),
                1,
            ),
        ],
        cell,
    )


wide, slim, huge = others(11), others(2), others(16)
exact = of(
    7.5,
    [
        (
            "a cell exactly SPARE + CELL / 2 away is far enough: only nearer ones are in the way",
            near_enough(10.01),
            0,
        )
    ],
)
close = others(4.8)  # 7.3 cm: a little more than to a cell at a corner
coarse = others(6, cell=10)  # the mat has 20 of them in a row
fine = others(6, cell=2.5)


def some_floor(task, across=40):
    free = {(column, row) for column in range(across) for row in range(across)}
    for _ in range(12):
        column, row = task.random.randrange(across - 2), task.random.randrange(across - 2)
        free -= {(column + i, row + j) for i in range(2) for j in range(2)}
    return free


@check("A passage three cells wide", hint=0)
def passage(task):
    free = {(column, row) for column in (10, 11, 12) for row in range(5, 30)}
    task.call(find_room, free, gives={(11, row) for row in range(6, 29)})
    across = {(column, row) for row in (10, 11, 12) for column in range(5, 30)}
    task.call(find_room, across, gives={(column, 11) for column in range(6, 29)})


@check("An empty mat, and none that is free", hint=1)
def empty(task):
    task.call(find_room, CELLS)
    task.call(find_room, CELLS - {(20, 20), (9, 0), (0, 0)})
    task.call(find_room, set(), gives=set())
    task.call(find_room, {(7, 7)}, gives=set())


@check("Boxes all about", hint=2)
def boxes(task):
    for _ in range(2):
        task.call(find_room, some_floor(task))


@check("Robots of other sizes", hint=2)
def sizes(task):
    task.set("SPARE", 11)
    task.call(wide, some_floor(task))
    task.set("SPARE", 2)
    task.call(slim, some_floor(task))
    task.set("SPARE", 4.8)
    task.call(close, some_floor(task))
    task.set("SPARE", 16)
    hall = {(column, row) for column in range(20) for row in range(16)}
    task.call(huge, hall - {(9, 7)})


@check("A cell just far enough away", hint=0)
def just(task):
    task.set("SPARE", 7.5)
    task.call(exact, some_floor(task))


@check("Cells of 10 cm, and of 2.5 cm", hint=2)
def of_other_sizes(task):
    task.set("CELL", 10)
    task.call(coarse, some_floor(task, 20))
    task.set("CELL", 2.5)
    task.call(fine, {(column, row) for column in range(20, 40) for row in range(12)})
