"""A small round robot on a 200 cm mat, and the calls to drive it and see through its eyes.

    from bugbot import *

    forward(50, distance=30)
    for angle, distance_cm in scan():
        print(angle, distance_cm)

May import: the rest of the package. What is imported here is what a program gets.
"""

from bugbot.api import (
    Robot,
    backward,
    battery,
    beep,
    clock,
    connect,
    distance,
    draw,
    drive,
    forward,
    go,
    heading,
    led,
    left,
    odometry,
    plot,
    position,
    right,
    scan,
    stop,
    turn,
    wait,
)
from bugbot.errors import BugbotError

__all__ = [
    "BugbotError",
    "Robot",
    "backward",
    "battery",
    "beep",
    "clock",
    "connect",
    "distance",
    "draw",
    "drive",
    "forward",
    "go",
    "heading",
    "led",
    "left",
    "odometry",
    "plot",
    "position",
    "right",
    "scan",
    "stop",
    "turn",
    "wait",
]
