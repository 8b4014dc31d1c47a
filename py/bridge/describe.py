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


def describe() -> dict[str, Any]:
    """The worlds, whole, and the robot's calls.

    Returns {"worlds": [world, …], "api": [{"name", "signature", "summary", "doc"}, …]}.
    """
    return {
        "worlds": [worlds.load(name).to_dict() for name in worlds.names()],
        "api": [_call(name) for name in bugbot.__all__ if inspect.isroutine(getattr(bugbot, name))],
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
