"""The four watched cells, the wall, and the robot's fan of beams where it starts."""

from bugbot.frames import direction
from sketch import Drawing

CELLS = {"floor": 122.5, "in front": 147.5, "wall": 152.5, "behind": 177.5}
X = 102.5
WALL_Y = 150
ROBOT = (100, 40)


def picture() -> str:
    """The picture as one <svg>."""
    drawing = Drawing(
        340,
        262,
        "The four watched cells",
        "The robot at (100, 40) looks up the mat at a wall whose face is at y = 150. Four cells "
        "of the same column are outlined: floor at y = 122.5, in front at 147.5, just below the "
        "wall's face, wall at 152.5, just above it, and behind at 177.5.",
    )
    mat = drawing.plane(34, 8, scale=1.55, width_cm=100, height_cm=160, origin=(50, 30))
    mat.ground()
    mat.rectangle((50, WALL_Y), 100, 8, "truth")
    for beam in range(8):
        dx, dy = direction(-19.6875 + 5.625 * beam)
        length = (WALL_Y - ROBOT[1]) / dy
        mat.line(ROBOT, (ROBOT[0] + length * dx, WALL_Y), "rest")
    mat.robot(ROBOT, 0)
    labels = {"floor": 122.5, "in front": 143.0, "wall": 157.0, "behind": 177.5}
    for name, y in CELLS.items():
        mat.rectangle((X - 2.5, y - 2.5), 5, 5, "outline")
        mat.line((X + 4, y), (153, labels[name]), "axis")
        mat.text((155, labels[name]), name, "strong", down=4)
        mat.text((202, labels[name]), f"y = {y:g}", "soft", down=4)
    mat.text((49, WALL_Y), "150", "small soft end", down=4)
    mat.text((49, ROBOT[1]), "40", "small soft end", down=4)
    return drawing.svg()
