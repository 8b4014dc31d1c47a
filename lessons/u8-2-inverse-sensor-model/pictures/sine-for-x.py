"""A beam as the long side of a triangle: sine goes with x, cosine with y."""

from mapping.beam import end_of_beam
from sketch import Drawing

ANGLE, LENGTH = 30, 100


def picture() -> str:
    """The beam of 100 cm at 30 degrees, with its two sides and the angle."""
    across, up = end_of_beam(0, 0, ANGLE, LENGTH)
    drawing = Drawing(
        340,
        287,
        "Where a beam ends",
        f"A beam of {LENGTH} cm leaves the robot {ANGLE} degrees clockwise from straight up the "
        f"mat. It ends {across:.0f} cm to the right, the sine of the angle times {LENGTH}, and "
        f"{up:.1f} cm up, the cosine times {LENGTH}.",
    )
    mat = drawing.plane(20, 8, scale=2.05, width_cm=146, height_cm=132, origin=(-26, -14))
    mat.ground()
    mat.line((0, 0), (0, 104), "rest")
    mat.arrow((0, 96), (0, 105))
    mat.text((0, 105), "heading 0", "on-mat small middle", down=-7)
    mat.line((across, 0), (across, up), "rest")
    mat.line((0, 0), (across, 0), "rest")
    mat.line((0, 0), (across, up), "beam")
    drawing.arc(mat.on_sheet((0, 0)), 62, 0, ANGLE, "arrow")
    mat.text((3, 34), "30°", "on-mat")
    mat.text((across + 3, up / 2 + 6), "100 × cos 30°", "on-mat")
    mat.text((across + 3, up / 2 + 6), f"= {up:.1f} cm", "on-mat", down=17)
    mat.text((12, 0), f"100 × sin 30° = {across:.0f} cm", "on-mat", down=18)
    mat.text((4, 62), "100 cm", "on-mat")
    mat.robot((0, 0), ANGLE)
    mat.dot((across, up), 4.5, "step")
    mat.text((across + 4, up), "the beam's end", "on-mat", down=4)
    return drawing.svg()
