"""A small map with its frontier cells, in regions: one that is worth a drive, one that is not."""

from mapping.frontiers import State, choose_goal, frontier_cells, regions
from mapping.grid import Grid
from sketch import Drawing

CELL_CM = 10.0
# . free, # occupied, blank unknown; the first row is the top one
ROWS = [
    "####   ######",
    "#       #...#",
    "#.......#...#",
    "#...........#",
    "#...........#",
    "#...........#",
    "##### #######",
]
WIDE, HIGH = 13, 7
ROBOT = (95.0, 25.0)


def picture() -> str:
    grid, states = read()
    groups = regions(grid, frontier_cells(grid, states))
    large, small = groups
    goal = choose_goal(grid, states, ROBOT)
    drawing = Drawing(
        340,
        187,
        "Frontier cells and regions",
        "A small map with walls round it. Where light blue floor meets unknown cells, the floor "
        f"cells are yellow with a dot: the frontier. One region has {len(large)} cells; the "
        "robot's goal, in a red ring, is the nearest of them with room for it. The other has "
        f"{len(small)} and is left out.",
    )
    mat = drawing.plane(7.5, 6, scale=2.5, width_cm=WIDE * CELL_CM, height_cm=HIGH * CELL_CM)
    mat.ground()
    for state, kind in ((State.FREE, "free"), (State.OCCUPIED, "occupied")):
        cells = (grid.cell(i) for i, each in enumerate(states) if each is state)
        mat.cells([cell for cell in cells if cell[0] < WIDE and cell[1] < HIGH], kind, CELL_CM)
    mat.cells([grid.cell(i) for i in large + small], "frontier", CELL_CM)
    mat.grid(CELL_CM)
    for index in large + small:
        mat.dot(grid.centre(index), 2.4, "step")
    if goal:
        mat.line(ROBOT, goal, "rest")
        mat.dot(goal, 8, "chosen")
    mat.robot(ROBOT, 0)
    mat.text((40, 55), f"region of {len(large)}: go there", "on-mat middle", down=4)
    x, y = grid.centre(small[0])
    mat.text((x + 8, y), f"region of {len(small)}: too small", "on-mat", down=4)
    return drawing.svg()


def read() -> tuple[Grid, list[State]]:
    """The map above as states of a grid that covers the mat; what is not shown counts as wall."""
    grid = Grid(CELL_CM)
    states = [State.OCCUPIED] * len(grid.cells)
    signs = {".": State.FREE, "#": State.OCCUPIED, " ": State.UNKNOWN}
    for up, row in enumerate(reversed(ROWS)):
        for column, sign in enumerate(row):
            states[grid.index((column, up))] = signs[sign]
    return grid, states
