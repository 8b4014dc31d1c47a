"""Slips with modules: other packages, a file of one's own, a name that is not in there.

May import: the standard library, `bugbot.errors`, the rest of `bugbot.run.slips`.
"""

from __future__ import annotations

import re
import sys

import bugbot
from bugbot.errors import nearest
from bugbot.run.slips.case import Case, Slip

__all__ = ["MODULES", "SLIPS"]

MODULES = ("collections", "copy", "functools", "itertools", "json", "math", "numpy", "random",
           "re", "statistics", "sys", "time")  # fmt: skip
"""Those that a program is likely to want."""

_THERE = "There is Python's own library (math, random, …), bugbot and numpy"
_DRAWING = "draw(name, points) draws on the mat, and plot(name, value) makes a chart"
_ROBOT = "the robot's calls are in bugbot: from bugbot import *"
_NETWORK = "a program here has no network"

_INSTEAD = {
    **dict.fromkeys(("matplotlib", "seaborn", "plotly", "bokeh"), _DRAWING),
    **dict.fromkeys(("turtle", "tkinter", "pygame", "graphics"), _DRAWING),
    **dict.fromkeys(
        ("cv2", "PIL", "skimage", "imageio"), f"a map is an array of numpy; {_DRAWING}"
    ),
    **dict.fromkeys(("pandas", "scipy", "sklearn", "torch", "tensorflow"), "numpy has arrays"),
    **dict.fromkeys(("rospy", "rclpy", "nav_msgs", "sensor_msgs", "geometry_msgs", "tf"), _ROBOT),
    **dict.fromkeys(("RPi", "gpiozero", "machine", "microbit", "serial", "pybricks"), _ROBOT),
    **dict.fromkeys(("requests", "httpx", "aiohttp", "flask", "socketio"), _NETWORK),
}
"""Packages that programs elsewhere import, and what there is here for it."""


def _own_file(case: Case) -> str | None:
    """`from .grid import Grid`: the program is taken for a file of a package."""
    if not isinstance(case.error, ImportError) or "relative import" not in case.message:
        return None
    return "A program here is one file: put what you want from the other file into this one."


def _not_in_it(case: Case) -> str | None:
    error = case.error
    if not isinstance(error, ImportError) or isinstance(error, ModuleNotFoundError):
        return None
    found = re.search(r"'(\w+)'", case.message)
    near = nearest(found[1], bugbot.__all__) if found else None
    return f"Did you mean {near}?" if near and error.name == "bugbot" else None


def _not_there(case: Case) -> str | None:
    error = case.error
    if not isinstance(error, ModuleNotFoundError):
        return None
    wanted = (error.name or "").partition(".")[0]
    if wanted in _INSTEAD:
        return f"{wanted} can't be had here: {_INSTEAD[wanted]}."
    near = nearest(wanted, ["bugbot", *MODULES])
    if near and near != wanted:
        letters = " Capital and small letters count." if near.lower() == wanted.lower() else ""
        return f"Did you mean {near}?{letters}"
    if wanted == "numpy":
        return "numpy is not there yet. On your own computer: python -m pip install numpy"
    if wanted in sys.stdlib_module_names:
        return f"{wanted} is part of Python, but can't be had in a browser."
    return (
        f"{_THERE}; other packages can't be had here. If {wanted} is a file of yours: a program "
        "here is one file, so put what you want from it into this one."
    )


SLIPS: tuple[Slip, ...] = (_own_file, _not_in_it, _not_there)
