"""One beam, and the log odds that it adds to each cell: the numbers come from `mapping`."""

from bugbot.frames import direction
from mapping.beam import clear_length
from mapping.mapper import Mapper
from sketch import Drawing

CELL = 5
X, Y, ANGLE, READING = 1.5, 3.3, 74.0, 36.5


def picture() -> str:
    """The picture as one <svg>."""
    mapper = Mapper(CELL)
    mapper.add_beam(X, Y, ANGLE, READING)
    drawing = Drawing(
        340,
        212,
        "What one beam adds to each cell",
        "A gently rising beam over cells of 5 cm. Dots mark its half-cell steps. A cell with "
        "two dots gets -0.8, with one dot -0.4, the cell where the beam ended +0.85. The cell "
        "just before it has no dot and gets nothing.",
    )
    mat = drawing.plane(10, 8, scale=8, width_cm=40, height_cm=20)
    mat.ground()
    grid = mapper.grid
    named = [(grid.cell(index), value) for index, value in enumerate(grid.cells) if value]
    mat.cells([cell for cell, value in named if value < 0], "free", CELL)
    mat.cells([cell for cell, value in named if value > 0], "occupied", CELL)
    mat.grid(CELL)
    dx, dy = direction(ANGLE)
    mat.line((X, Y), (X + READING * dx, Y + READING * dy), "beam")
    for step in range(int(clear_length(READING, CELL) / (CELL / 2))):
        along = step * CELL / 2
        mat.dot((X + along * dx, Y + along * dy), 3, "step")
    for (column, row), value in named:
        words = f"{value:+.2f}" if value > 0 else f"−{-value:.1f}"
        kind = "small middle on-black" if value > 0 else "small middle on-mat"
        middle = ((column + 0.5) * CELL, (row + 0.5) * CELL)
        beam_y = Y + (middle[0] - X) * dy / dx
        # On the side of the cell where the beam leaves more room.
        mat.text(middle, words, kind, down=16 if beam_y > middle[1] else -7)
    drawing.text(10, 188, "dots: half-cell steps of the beam, 2.5 cm apart", "small soft")
    drawing.text(10, 205, "the cell before the hit has no dot and gets nothing", "small soft")
    return drawing.svg()
