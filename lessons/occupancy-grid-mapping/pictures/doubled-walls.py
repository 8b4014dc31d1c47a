"""One scan drawn twice: with the true heading, and with one that has drifted by 30 degrees."""

from math import inf

from bugbot.frames import direction
from mapping.frontiers import State, known_states
from mapping.mapper import Mapper
from sketch import Drawing

CELL_CM, DRIFT_DEG = 5.0, 30.0
ROBOT = (60.0, 30.0)
WALL = (20.0, 80.0, 80.0, 8.0)
BEAMS = [1.875 * (i - 23.5) for i in range(48)]


def picture() -> str:
    drawing = Drawing(
        340,
        304,
        "A doubled wall",
        "A robot below a wall. The wall's black cells from the first look lie on the wall. "
        "Those from the second look, drawn with a heading that is 30 degrees wrong, form the "
        "same wall once more, turned clockwise round the robot, with nothing real beneath. They "
        "are outlined.",
    )
    mat = drawing.plane(5, 5, scale=2.36, width_cm=140, height_cm=110)
    mat.ground()
    first, second = occupied(0), occupied(DRIFT_DEG)
    mat.rectangle(WALL[:2], *WALL[2:], "truth")
    mat.cells(free(), "free", CELL_CM)
    mat.grid(CELL_CM)
    mat.rectangle(WALL[:2], *WALL[2:], "truth")
    mat.cells(first, "occupied", CELL_CM)
    mat.cells([cell for cell in second if cell not in first], "doubled", CELL_CM)
    middle = (ROBOT[0], WALL[1])
    mat.line(ROBOT, middle, "beam")
    dx, dy = direction(DRIFT_DEG)
    mat.line(ROBOT, (ROBOT[0] + 50 * dx, ROBOT[1] + 50 * dy), "rest")
    drawing.arc(mat.on_sheet(ROBOT), 62, 0, DRIFT_DEG, "outline")
    mat.robot(ROBOT, 0)
    mat.text((138, 96), "first look:", "on-mat end")
    mat.text((138, 89), "on the wall", "on-mat end", down=-1)
    mat.text((138, 28), "second look:", "on-mat end")
    mat.text((138, 21), "the same wall, 30° off", "on-mat end")
    drawing.text(5, 282, "Green line: where the robot looks.", "ink small")
    drawing.text(5, 299, "Dotted: where it believes it looks.", "ink small")
    return drawing.svg()


def mapped(drift_deg: float) -> Mapper:
    """A map of the wall from two equal looks, every beam drawn `drift_deg` to the right."""
    mapper = Mapper(CELL_CM)
    for _ in range(2):
        mapper.add_scan(*ROBOT, drift_deg, [(angle, reading(angle)) for angle in BEAMS])
    return mapper


def reading(angle_deg: float) -> float:
    """The true distance to the wall's lower face [cm]."""
    dx, dy = direction(angle_deg)
    distance = (WALL[1] - ROBOT[1]) / dy if dy > 0 else inf
    meets = WALL[0] <= ROBOT[0] + distance * dx <= WALL[0] + WALL[2]
    return distance if meets else 200.0


def occupied(drift_deg: float) -> list[tuple[int, int]]:
    """The cells that a look turned by `drift_deg` makes black."""
    grid = mapped(drift_deg).grid
    states = known_states(grid.cells, 0.8)
    return [grid.cell(i) for i, state in enumerate(states) if state is State.OCCUPIED]


def free() -> list[tuple[int, int]]:
    """The cells in the window that the true look makes free."""
    grid = mapped(0).grid
    cells = [
        grid.cell(i) for i, state in enumerate(known_states(grid.cells)) if state is State.FREE
    ]
    return [(column, row) for column, row in cells if column < 28 and row < 16]
