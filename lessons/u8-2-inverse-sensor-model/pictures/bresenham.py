"""Bresenham's line between two cells, with the true line through it."""

from mapping.beam import bresenham
from sketch import Drawing

LAST = (7, 3)


def picture() -> str:
    """The cells of the line, numbered by step, and the true line from middle to middle."""
    line = bresenham((0, 0), LAST)
    drawing = Drawing(
        340,
        210,
        "Bresenham's line",
        f"A line of {len(line)} cells from (0, 0) to {LAST}. Each step goes one column to the "
        "right; steps 2, 4 and 6 go up one row as well. The true line runs from middle to middle "
        "and is never more than half a cell above or below the middle of its cell.",
    )
    grid = drawing.plane(34, 10, scale=37, width_cm=8, height_cm=4)
    grid.ground()
    grid.cells(line, "free", 1)
    grid.grid(1)
    grid.line((0.5, 0.5), (LAST[0] + 0.5, LAST[1] + 0.5), "beam")
    for step, (column, row) in enumerate(line):
        grid.dot((column + 0.5, row + 0.5), 3, "step")
        grid.text((column + 0.94, row + 0.06), str(step), "on-mat small end", down=-1)
    for column in range(8):
        grid.text((column + 0.5, 0), str(column), "soft middle", down=17)
    for row in range(4):
        x, y = grid.on_sheet((0, row + 0.5))
        drawing.text(x - 10, y + 4, str(row), "soft end")
    grid.text((4, 0), "column", "soft middle", down=36)
    return drawing.svg()
