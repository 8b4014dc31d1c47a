"""Why the cell in front of a wall ends as wall: where noisy readings of its face end."""

from math import exp

from mapping.beam import clear_length
from sketch import Drawing

CELL_CM, NOISE_CM = 5.0, 2.0
FACE_CM = 20.0


def picture() -> str:
    drawing = Drawing(
        340,
        240,
        "Why walls come out thick",
        "A row of cells up to a wall. Readings of the wall's face scatter around it like a "
        "bell, so half of them end in the cell in front of the wall and half in the wall's own. "
        "Both cells are black. Free floor is claimed only up to one cell short of each "
        "reading, which for most readings lies before the cell in front.",
    )
    scale = 330 / 30
    row = drawing.plane(5, 128, scale=scale, width_cm=30, height_cm=CELL_CM)
    row.ground()
    row.cells([(column, 0) for column in range(3)], "free", CELL_CM)
    row.cells([(3, 0), (4, 0)], "occupied", CELL_CM)
    row.grid(CELL_CM)
    row.text((17.5, 2.5), "in front", "on-black middle", down=5)
    row.text((22.5, 2.5), "wall", "on-black middle", down=5)
    row.text((7.5, 2.5), "floor", "on-mat middle", down=5)
    row.text((27.5, 2.5), "behind", "on-mat middle", down=5)
    row.rectangle((FACE_CM, -1.6), 8, 1.1, "truth")
    drawing.text(225, 216, "the real wall", "ink")

    bell = drawing.plane(5, 30, scale=scale, scale_y=80, width_cm=30, height_cm=1)
    points = [(x / 5, exp(-0.5 * ((x / 5 - FACE_CM) / NOISE_CM) ** 2)) for x in range(60, 141)]
    bell.curve([(points[0][0], 0), *points, (points[-1][0], 0)], "curve", closed=True)
    bell.line((0, 0), (30, 0), "axis")
    bell.line((FACE_CM, 0), (FACE_CM, 1.08), "guide")
    bell.text((FACE_CM - 3.2, 1.06), "half end here", "ink end")
    bell.text((FACE_CM + 3.2, 1.06), "half here", "ink")
    bell.text((0.3, 0.42), "readings of the", "soft")
    bell.text((0.3, 0.24), "wall’s face", "soft")

    silent = clear_length(FACE_CM, CELL_CM)
    below = drawing.plane(5, 190, scale=scale, width_cm=30, height_cm=1)
    below.arrow((0.2, 0.4), (silent, 0.4), "curve")
    drawing.text(5, 219, "passes speak up to here,", "ink")
    drawing.text(5, 235, "one cell before the end", "ink")
    return drawing.svg()
