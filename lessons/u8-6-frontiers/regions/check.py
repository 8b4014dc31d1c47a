"""find_regions(cells): groups of cells that are connected by sides or corners."""

from grader import check, function, in_any_order
from mapping.frontiers import regions
from mapping.grid import Grid

MAT = Grid(10)


def grouped(corners):
    return lambda cells: [
        {MAT.cell(index) for index in group}
        for group in regions(MAT, map(MAT.index, cells), corners=corners)
    ]


def one_for_each(cells):
    """A group is found anew from each of its cells."""
    return [group for group in grouped(corners=True)(cells) for _ in group]


def one_round(cells):
    """Only the cells beside the first one of a group are found."""
    left, groups = set(cells), []
    while left:
        column, row = min(left)
        near = {(column + c, row + r) for c in (-1, 0, 1) for r in (-1, 0, 1)} & left
        groups.append(near)
        left -= near
    return groups


find_regions = function(
    "find_regions(cells)",
    grouped(corners=True),
    compare=in_any_order.deep(2),
    cell_cm=10,
    leaves=True,
    mistakes=[
        (
            "only sides were counted: cells that touch at a corner are connected too",
            grouped(corners=False),
            2,
        ),
        ("all cells came in one group", lambda cells: [set(cells)] if cells else [], 0),
        ("every cell came as a group of its own", lambda cells: [{cell} for cell in cells], 0),
        (
            "only the neighbours of the first cell were found: "
            "their neighbours belong to the group too",
            one_round,
            1,
        ),
        (
            "a group comes once for each of its cells: what is in a group has to leave `left`",
            one_for_each,
            1,
        ),
        (
            "groups of one cell are missing: a cell with no neighbours is a group too",
            lambda cells: [group for group in grouped(corners=True)(cells) if len(group) > 1],
            0,
        ),
    ],
)


@check("Two groups", hint=0)
def two(task):
    groups = [{(3, 3), (4, 3), (5, 3)}, {(10, 7), (10, 8)}]
    task.call(find_regions, set().union(*groups), gives=groups)
    task.call(find_regions, set(), gives=[])


@check("A group that winds", hint=1)
def winding(task):
    ring = {(c, r) for c in range(4, 13) for r in range(4, 13) if c in (4, 12) or r in (4, 12)}
    task.call(find_regions, ring, gives=[ring])
    task.call(find_regions, ring | {(8, 8)}, gives=[ring, {(8, 8)}])


@check("A slanting line", hint=2)
def slanting(task):
    for line in (
        {(column, column + 2) for column in range(12)},
        {(column, 15 - column) for column in range(12)},
    ):
        task.call(find_regions, line, gives=[line])
    edges = {(0, 5), (19, 5), (7, 0), (7, 19), (0, 0), (19, 19)}
    task.call(find_regions, edges, gives=[{cell} for cell in edges])


@check("Cells strewn about", hint=2)
def strewn(task):
    cells = [(column, row) for row in range(20) for column in range(20)]
    for count in (40, 90, 140):
        task.call(find_regions, set(task.random.sample(cells, count)))
