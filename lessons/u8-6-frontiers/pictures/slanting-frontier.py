"""A slanting frontier, joined by sides and by corners: the groups come from `mapping`."""

from mapping.frontiers import State, frontier_cells, regions
from mapping.grid import Grid
from sketch import Drawing

ACROSS, CELL = 40, 5
WIDE, HIGH = 8, 7  # cells of the piece that is shown


def picture() -> str:
    """The picture as one <svg>."""
    grid = Grid(CELL)
    free = {(c, r) for r in range(HIGH) for c in range(WIDE) if 2 * c < 6 + r * 1.4}
    states = [
        State.UNKNOWN
        if grid.cell(i)[0] < WIDE and grid.cell(i)[1] < HIGH and grid.cell(i) not in free
        else State.FREE
        if grid.cell(i) in free
        else State.OCCUPIED
        for i in range(len(grid.cells))
    ]
    frontier = frontier_cells(grid, states)
    by_sides = regions(grid, frontier)
    by_corners = regions(grid, frontier, corners=True)
    drawing = Drawing(
        340,
        196,
        "A slanting frontier",
        f"The same {len(frontier)} frontier cells twice. By sides they fall into {len(by_sides)} "
        f"regions, by sides and corners they are {len(by_corners)}. Each cell has the number "
        "of its region.",
    )
    for left, groups, words in (
        (8, by_sides, f"by sides: {len(by_sides)} regions"),
        (176, by_corners, f"corners too: {len(by_corners)} region"),
    ):
        mat = drawing.plane(left, 8, scale=3.9, width_cm=WIDE * CELL, height_cm=HIGH * CELL)
        mat.ground()
        mat.cells(sorted(free), "free", CELL)
        mat.grid(CELL)
        for number, group in enumerate(sorted(groups), 1):
            for index in group:
                mat.text(grid.centre(index), str(number), "small middle on-mat", down=4)
        drawing.text(left, 168, words, "small")
    drawing.text(8, 188, "blue: free, bare: unknown; a number: a frontier cell", "small soft")
    return drawing.svg()
