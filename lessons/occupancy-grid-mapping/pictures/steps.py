"""One slanting beam by three rules: which of the cells it goes through does each name?"""

from itertools import pairwise
from math import floor

from bugbot.frames import direction
from mapping.beam import end_of_beam, passed_by_bresenham, passed_by_steps
from sketch import Drawing, Plane

CELL_CM = 10.0
START, ANGLE_DEG, LENGTH_CM = (5.0, 3.0), 62.0, 95.0
WIDE, HIGH = 11, 5


def picture() -> str:
    crossed = cells_crossed()
    rules = [
        ("Half-cell steps", passed_by_steps(*START, ANGLE_DEG, LENGTH_CM, CELL_CM), CELL_CM / 2),
        ("Whole-cell steps", whole_steps(), CELL_CM),
        ("Bresenham", passed_by_bresenham(*START, ANGLE_DEG, LENGTH_CM, CELL_CM), None),
    ]
    counts = ". ".join(
        f"{name}: {len(crossed & set(cells))} of these cells named, "
        f"{len(cells) - len(set(cells))} of them twice"
        for name, cells, _ in rules
    )
    drawing = Drawing(
        340,
        3 * 178,
        "A beam and its cells by three rules",
        f"The same slanting beam over a grid, three times. It goes through {len(crossed)} cells. "
        f"{counts}. The cells left out are marked with a cross.",
    )
    for place, (name, cells, step) in enumerate(rules):
        panel(drawing, 178 * place, name, cells, step, crossed)
    return drawing.svg()


def panel(
    drawing: Drawing,
    top: float,
    name: str,
    cells: list[tuple[int, int]],
    step: float | None,
    crossed: set[tuple[int, int]],
) -> None:
    """One rule: its name, the cells it names, its steps as dots, a cross where it named none."""
    named = set(cells)
    twice = len(cells) - len(named)
    drawing.text(5, top + 14, name, "ink strong")
    said = f"{len(crossed & named)} of {len(crossed)} cells" + (f", {twice} twice" if twice else "")
    drawing.text(335, top + 14, said, "soft end")
    mat = drawing.plane(5, top + 21, scale=3, width_cm=WIDE * CELL_CM, height_cm=HIGH * CELL_CM)
    mat.ground()
    mat.cells(sorted(named), "free", CELL_CM)
    mat.grid(CELL_CM)
    mat.line(START, end_of_beam(*START, ANGLE_DEG, LENGTH_CM), "beam")
    for column, row in sorted(crossed - named):
        mat.cross(((column + 0.5) * CELL_CM, (row + 0.5) * CELL_CM), 5)
    if step:
        dots(mat, step)


def dots(mat: Plane, step: float) -> None:
    """A dot at each step along the beam."""
    for i in range(int(LENGTH_CM / step)):
        mat.dot(end_of_beam(*START, ANGLE_DEG, i * step), 3, "step")


def whole_steps() -> list[tuple[int, int]]:
    """The cell at each step of a whole cell: the rule that leaves speckles."""
    points = (end_of_beam(*START, ANGLE_DEG, i * CELL_CM) for i in range(int(LENGTH_CM / CELL_CM)))
    return [(floor(x / CELL_CM), floor(y / CELL_CM)) for x, y in points]


def cells_crossed() -> set[tuple[int, int]]:
    """Every cell that the beam goes through: between two lines of the grid it is in one cell."""
    dx, dy = direction(ANGLE_DEG)
    at = {0.0, LENGTH_CM}
    for i in range(1, WIDE + 1):
        at.add((i * CELL_CM - START[0]) / dx)
        at.add((i * CELL_CM - START[1]) / dy)
    along = sorted(each for each in at if 0 <= each <= LENGTH_CM)
    middles = [(a + b) / 2 for a, b in pairwise(along)]
    points = (end_of_beam(*START, ANGLE_DEG, middle) for middle in middles)
    return {(floor(x / CELL_CM), floor(y / CELL_CM)) for x, y in points}
