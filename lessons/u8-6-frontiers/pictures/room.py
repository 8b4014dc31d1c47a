"""Room for the robot at a doorway: which cells have it comes from `mapping.planning`."""

from mapping.frontiers import State
from mapping.grid import Grid
from mapping.planning import room_cells
from sketch import Drawing

CELL, SPARE = 5, 6
LEFT, BOTTOM, WIDE, HIGH = 14, 20, 12, 10  # the piece of the mat that is shown, in cells


def picture() -> str:
    """The picture as one <svg>."""
    grid = Grid(CELL)
    solid = {(c, r) for c in range(grid.across) for r in (24, 25) if not 18 <= c < 22}
    states = [
        State.OCCUPIED if grid.cell(index) in solid else State.FREE
        for index in range(len(grid.cells))
    ]
    room = {grid.cell(index) for index in room_cells(grid, states, SPARE)}
    shown = [(c, r) for r in range(BOTTOM, BOTTOM + HIGH) for c in range(LEFT, LEFT + WIDE)]
    drawing = Drawing(
        340,
        302,
        "Room at a doorway",
        "A wall of two rows of cells with a doorway four cells wide. Cells within one cell of the "
        "wall have no room for the middle of the robot. A lane two cells wide, "
        "marked with dots, is left through the doorway, and the robot stands in it.",
    )
    mat = drawing.plane(
        20,
        8,
        scale=5,
        width_cm=WIDE * CELL,
        height_cm=HIGH * CELL,
        origin=(LEFT * CELL, BOTTOM * CELL),
    )
    mat.ground()
    mat.cells([cell for cell in shown if cell not in solid], "free", CELL)
    mat.cells([cell for cell in shown if cell in solid], "occupied", CELL)
    mat.grid(CELL)
    mat.robot((97.5, 127.5), 0)
    for cell in shown:
        if cell in room:
            mat.dot(((cell[0] + 0.5) * CELL, (cell[1] + 0.5) * CELL), 3, "step")
    drawing.text(20, 278, "black: wall; blue: free floor", "small soft")
    drawing.text(20, 295, "dot: the middle of the robot may be here", "small soft")
    return drawing.svg()
