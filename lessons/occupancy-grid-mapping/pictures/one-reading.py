"""One reading of 100 cm along a row of cells: what it says, and about which of them."""

from mapping.beam import clear_length, end_of_hit, passed_by_steps
from sketch import Drawing

CELL_CM, READING_CM = 5.0, 82.5
START = (7.5, 7.5)


def picture() -> str:
    row = int(START[1] // CELL_CM)
    clear_cm = clear_length(READING_CM, CELL_CM)
    passed = sorted(set(passed_by_steps(*START, 90, clear_cm, CELL_CM)))
    end = end_of_hit(*START, 90, READING_CM)
    assert end is not None
    hit = (int(end[0] // CELL_CM), row)

    drawing = Drawing(
        340,
        136,
        "What one reading says",
        f"A robot looks along a row of cells. The {len(passed)} cells that the beam passed are "
        "light blue and marked with a minus: more likely free. The cell just before the end has "
        "no mark. The cell where the beam ended is black and marked with a plus: more likely "
        "occupied. Behind it the cells are bare: nothing is said about them.",
    )
    mat = drawing.plane(5, 40, scale=3, width_cm=110, height_cm=15)
    mat.ground()
    mat.cells(passed, "free", CELL_CM)
    mat.cells([hit], "occupied", CELL_CM)
    mat.grid(CELL_CM)
    mat.line(START, end, "beam")
    for column, _ in passed:
        if column > 2:
            middle = (column + 0.5) * CELL_CM
            mat.text((middle, 12.5), "−", "on-mat middle", down=4.5)
    mat.text(((hit[0] + 0.5) * CELL_CM, 12.5), "+", "on-mat strong middle", down=4.5)
    mat.robot(START, 90)

    first = mat.on_sheet((passed[0][0] * CELL_CM, 0))[0]
    last = mat.on_sheet(((passed[-1][0] + 1) * CELL_CM, 0))[0]
    bracket(drawing, first, last, 30, up=True)
    drawing.text((first + last) / 2, 20, "passed: more likely free", "ink middle")
    x = mat.on_sheet(end)[0]
    drawing.line((x, 88), (x, 98), "axis")
    drawing.text(x + 8, 112, "ended here: more likely occupied", "ink end")
    drawing.text(335, 130, "beyond: nothing is said", "soft end")
    return drawing.svg()


def bracket(drawing: Drawing, left: float, right: float, y: float, *, up: bool) -> None:
    """A flat bracket over cells."""
    foot = y + 6 if up else y - 6
    drawing.polyline([(left, foot), (left, y), (right, y), (right, foot)], "axis")
