"""A heading clockwise from up the mat, and its direction by sine and cosine."""

from bugbot.frames import direction
from sketch import Drawing

HEADING_DEG, LENGTH_CM = 35.0, 62.0
ROBOT = (30.0, 22.0)


def picture() -> str:
    dx, dy = direction(HEADING_DEG)
    tip = (ROBOT[0] + LENGTH_CM * dx, ROBOT[1] + LENGTH_CM * dy)
    drawing = Drawing(
        340,
        250,
        "Heading, sine and cosine",
        "The mat with x to the right and y up. A robot in the lower left has a heading of "
        f"{HEADING_DEG:g} degrees, measured clockwise from straight up the mat. Its beam is the "
        "long side of a right-angled triangle: the side across is the sine of the heading, the "
        "side up the cosine.",
    )
    mat = drawing.plane(5, 5, scale=3, width_cm=110, height_cm=80)
    mat.ground()
    mat.grid(10)
    mat.arrow((0.4, 0.4), (108, 0.4))
    mat.arrow((0.4, 0.4), (0.4, 78))
    mat.text((103, 4), "x", "on-mat strong")
    mat.text((4, 74), "y", "on-mat strong", down=4)

    mat.line(ROBOT, (ROBOT[0], tip[1]), "arrow")
    mat.line((ROBOT[0], tip[1]), tip, "arrow")
    mat.line(ROBOT, tip, "beam")
    mat.dot(tip, 3, "step")
    drawing.arc(mat.on_sheet(ROBOT), 60, 0, HEADING_DEG, "outline")
    mat.text((ROBOT[0] + 3.4, ROBOT[1] + 24), "h", "on-mat strong", down=4)
    mat.text((ROBOT[0] - 3, (ROBOT[1] + tip[1]) / 2), "d · cos h", "on-mat end", down=4)
    mat.text(((ROBOT[0] + tip[0]) / 2, tip[1]), "d · sin h", "on-mat middle", down=-6)
    mat.text((tip[0] + 3, tip[1]), "the end", "on-mat", down=1)
    mat.text((tip[0] + 3, tip[1]), "of the beam", "on-mat", down=16)
    mat.text(((ROBOT[0] + tip[0]) / 2 + 4, (ROBOT[1] + tip[1]) / 2 - 4), "d", "on-mat strong")
    mat.robot(ROBOT, HEADING_DEG)
    mat.text((ROBOT[0] + 8, ROBOT[1] - 7), "heading 0 is up, 90 is right", "on-mat", down=4)
    return drawing.svg()
