"""The lower left corner of the mat: how a point finds its cell."""

from bugbot.frames import cell_of
from sketch import Drawing

CELL = 5
POINT = (12.5, 7.0)
COLUMNS, ROWS = 5, 3


def picture() -> str:
    """The mat's corner with cells of 5 cm, columns and rows numbered, one point in its cell."""
    cell = cell_of(*POINT, CELL)
    if cell is None:
        raise ValueError("the point must lie on the mat")
    drawing = Drawing(
        340,
        212,
        "A point and its cell",
        f"Cells of {CELL} cm in the lower left corner of the mat. Columns are numbered from 0 to "
        f"{COLUMNS - 1} from the left, rows from 0 to {ROWS - 1} from the bottom. The point "
        f"{POINT} lies in column {cell[0]}, row {cell[1]}.",
    )
    mat = drawing.plane(
        58, 10, scale=10.5, width_cm=COLUMNS * CELL, height_cm=ROWS * CELL, origin=(0, 0)
    )
    mat.ground()
    mat.cells([cell], "free", CELL)
    mat.grid(CELL)
    mat.line((POINT[0], 0), POINT, "rest")
    mat.line((0, POINT[1]), POINT, "rest")
    mat.dot(POINT, 4.5, "step")
    mat.text((POINT[0] + 1.0, POINT[1] + 3.9), "(12.5, 7)", "on-mat small")
    for column in range(COLUMNS):
        mat.text(((column + 0.5) * CELL, 0), str(column), "strong middle", down=34)
    for row in range(ROWS):
        x, y = mat.on_sheet((0, (row + 0.5) * CELL))
        drawing.text(x - 32, y + 4, str(row), "strong middle")
    for line in range(COLUMNS + 1):
        mat.text((line * CELL, 0), str(line * CELL), "soft small middle", down=15)
    for line in range(1, ROWS + 1):
        x, y = mat.on_sheet((0, line * CELL))
        drawing.text(x - 5, y + 4, str(line * CELL), "soft small end")
    _, y = mat.on_sheet((0, 0))
    drawing.text(2, y + 15, "x in cm", "soft small")
    drawing.text(2, y + 34, "column", "strong")
    drawing.text(2, 14, "row", "strong")
    return drawing.svg()
