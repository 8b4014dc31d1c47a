"""Describes the course's Python to the page as plain data, at build time.

The robot's calls are taken from their own signatures and docstrings, so the editor's help and the
reference page can never say anything else than `help()` does.
"""

from __future__ import annotations

import inspect
from typing import Any

import bugbot
from bugbot import worlds

__all__ = ["describe"]

_GROUPS = {
    "Moving": ("drive", "forward", "backward", "left", "right", "turn", "stop"),
    "Time": ("wait", "clock"),
    "Sensing": ("scan", "distance", "position", "heading", "odometry", "battery"),
    "Showing": ("draw", "plot", "led", "beep"),
    "The robot as an object": ("connect", "Robot", "go"),
}
"""How the reference page orders the calls; together every public name, each once."""


def describe() -> dict[str, Any]:
    """The worlds, whole, and the robot's calls.

    Returns {"worlds": [world, …], "api": [{"name", "signature", "summary", "doc"}, …],
    "groups": [{"title", "names": [name, …]}, …]}.
    """
    return {
        "worlds": [worlds.load(name).to_dict() for name in worlds.names()],
        "api": [_call(name) for names in _GROUPS.values() for name in names],
        "groups": [{"title": title, "names": list(names)} for title, names in _GROUPS.items()],
    }


def _call(name: str) -> dict[str, str]:
    thing = getattr(bugbot, name)
    doc = inspect.getdoc(thing) or ""
    parameters = inspect.signature(thing).replace(return_annotation=inspect.Signature.empty)
    plain = parameters.replace(
        parameters=[
            parameter.replace(annotation=inspect.Parameter.empty)
            for parameter in parameters.parameters.values()
        ]
    )
    return {
        "name": name,
        "signature": f"{name}{plain}",
        "summary": doc.split("\n\n")[0].replace("\n", " "),
        "doc": doc,
    }
