"""A robot that faces one way and drives another: how much of it is ahead, how much to the right."""

from math import atan2, cos, hypot, radians, sin

from bugbot.frames import direction
from sketch import Drawing

ROBOT = (16.0, 8.0)
TARGET = (40.0, 32.0)
FACING = 15.0


def picture() -> str:
    """The picture as one <svg>."""
    drawing = Drawing(
        340,
        236,
        "Ahead and to the right",
        "A robot faces nearly up the mat. Its target lies up and to the right. The way there is "
        "the sum of an arrow ahead of the robot and an arrow to its right.",
    )
    mat = drawing.plane(10, 8, scale=4.6, width_cm=69, height_cm=40)
    mat.ground()
    dx, dy = TARGET[0] - ROBOT[0], TARGET[1] - ROBOT[1]
    off = atan2(dx, dy) - radians(FACING)
    ahead, aside = direction(FACING), direction(FACING + 90)
    forward, right = hypot(dx, dy) * cos(off), hypot(dx, dy) * sin(off)
    corner = (ROBOT[0] + forward * ahead[0], ROBOT[1] + forward * ahead[1])
    end = (corner[0] + right * aside[0], corner[1] + right * aside[1])
    mat.line(ROBOT, TARGET, "beam")
    mat.robot(ROBOT, FACING)
    mat.arrow(ROBOT, corner)
    mat.arrow(corner, end)
    mat.dot(TARGET, 4, "step")
    mat.text((corner[0] - 11, 22), "forward", "small middle on-mat")
    mat.text((33, corner[1] + 1.5), "right", "small middle on-mat")
    mat.text((TARGET[0] + 2, TARGET[1] - 2.5), "target", "small on-mat")
    mat.text((33, 15), "the way: dx, dy", "small on-mat")
    drawing.text(10, 210, "forward: the cosine of the angle between", "small soft")
    drawing.text(10, 227, "right: the sine of it", "small soft")
    return drawing.svg()
