"""The hits on one straight wall, as believed before and after the heading drifted by 10 degrees."""

from bugbot.frames import direction
from mapping.beam import end_of_beam
from sketch import Drawing

ROBOT = (60.0, 12.0)
WALL_Y = 72.0
DRIFT_DEG = 10.0
FAN = [-19.6875 + 5.625 * i for i in range(8)]


def picture() -> str:
    drawing = Drawing(
        340,
        262,
        "The same wall, seen twice",
        "A robot below a straight wall. The eight hits of the first look lie on the wall. Those of "
        "the second look lie on a straight line, too, but it is turned by 10 degrees clockwise "
        "round the robot. The angle between the two lines is what the heading has drifted by.",
    )
    mat = drawing.plane(5, 5, scale=2.75, width_cm=120, height_cm=80)
    mat.ground()
    mat.rectangle((0, WALL_Y), 120, 8, "truth")
    for drift, mark in ((0.0, "before"), (DRIFT_DEG, "after")):
        hits = [end_of_beam(*ROBOT, angle + drift, reading(angle)) for angle in FAN]
        mat.line(hits[0], hits[-1], "beam" if mark == "before" else "rest")
        for hit in hits:
            if mark == "before":
                mat.dot(hit, 4, "step")
            else:
                mat.cross(hit, 4)
    mat.robot(ROBOT, 0)
    mat.text((4, 60), "dots: first look", "on-mat")
    mat.text((117, 44), "crosses: second look", "on-mat end")
    drawing.text(5, 242, "Both looks are of the same wall, and equally good.", "ink small")
    drawing.text(5, 258, "The angle between the lines is the drift: 10 degrees.", "ink small")
    return drawing.svg()


def reading(angle_deg: float) -> float:
    """The true distance to the wall [cm]."""
    return (WALL_Y - ROBOT[1]) / direction(angle_deg)[1]
