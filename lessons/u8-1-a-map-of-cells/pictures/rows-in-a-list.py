"""A grid of rows, and the same cells as one list."""

from sketch import Drawing

ACROSS, ROWS = 4, 3
CHOSEN = (1, 2)
SIDE = 36
BOX = 27


def picture() -> str:
    """Twelve cells with their places, above the list they make."""
    place = CHOSEN[1] * ACROSS + CHOSEN[0]
    drawing = Drawing(
        340,
        226,
        "A grid as one list",
        f"A grid of {ACROSS} columns and {ROWS} rows. Its cells are numbered from 0 to "
        f"{ACROSS * ROWS - 1}, row after row from the bottom. Below, the same numbers as one list. "
        f"The cell in column {CHOSEN[0]}, row {CHOSEN[1]} has the place {place} in it.",
    )
    grid = drawing.plane(98, 10, scale=SIDE, width_cm=ACROSS, height_cm=ROWS)
    grid.ground()
    grid.cells([(column, 1) for column in range(ACROSS)], "wall", 1)
    grid.cells([CHOSEN], "free", 1)
    grid.grid(1)
    for index in range(ACROSS * ROWS):
        column, row = index % ACROSS, index // ACROSS
        grid.text((column + 0.5, row + 0.5), str(index), "on-mat middle", down=4.5)
    for row in range(ROWS):
        x, y = grid.on_sheet((0, row + 0.5))
        drawing.text(x - 8, y + 4, f"row {row}", "soft end")
    for column in range(ACROSS):
        grid.text((column + 0.5, 0), str(column), "soft middle", down=17)
    x, y = grid.on_sheet((ACROSS, 0))
    drawing.text(x + 8, y + 17, "column", "soft")

    row_of_boxes = drawing.plane(8, 168, scale=BOX, width_cm=ACROSS * ROWS, height_cm=1)
    row_of_boxes.ground()
    row_of_boxes.cells([(ACROSS + column, 0) for column in range(ACROSS)], "wall", 1)
    row_of_boxes.cells([(place, 0)], "free", 1)
    row_of_boxes.grid(1)
    for index in range(ACROSS * ROWS):
        row_of_boxes.text((index + 0.5, 0.5), str(index), "on-mat middle", down=4.5)
    for row in range(ROWS):
        row_of_boxes.text(((row + 0.5) * ACROSS, 0), f"row {row}", "soft middle", down=17)
    return drawing.svg()
