"""What a program may not use while it is marked, and how it is told so.

May import: the standard library, `bugbot.errors`.

A marked program runs in the same interpreter as the simulator that holds the hidden world. Two
fences stand between them, and a third behind both: whatever gets through, the judge holds the trace
against the truth (`grader.trust`).

* `performer.refusal` reads the program before it runs. It names the line and what is not allowed.
* `fenced` takes away, for the time of the run, what a program could not have used
  honestly: our own modules, the file system, import of anything not in `ALLOWED`.
"""

from __future__ import annotations

import builtins
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, NoReturn

from bugbot.errors import BugbotError

__all__ = ["ALLOWED", "NotAllowedError", "fenced", "why_not"]

ALLOWED = (
    "__future__",
    "abc",
    "array",
    "bisect",
    "bugbot",
    "cmath",
    "collections",
    "copy",
    "dataclasses",
    "decimal",
    "enum",
    "fractions",
    "functools",
    "heapq",
    "itertools",
    "json",
    "math",
    "numpy",
    "operator",
    "random",
    "re",
    "statistics",
    "string",
    "textwrap",
    "time",
    "typing",
)
"""Modules that a marked program may import."""

_HIDDEN = ("mapping", "grader", "bridge")
"""Taken from sys.modules: the reference, and the judge."""


class NotAllowedError(BugbotError, ImportError):
    """A program uses something that it may not while it is marked."""


def why_not(module: str) -> str | None:
    """Why a marked program may not import a module; None if it may."""
    root = module.partition(".")[0]
    if root in ALLOWED and (module == root or root in ("collections", "numpy", "json")):
        return None
    if root == "bugbot":
        return "a program may use bugbot's calls, not its inner parts"
    others = ", ".join(name for name in ALLOWED if not name.startswith("_"))
    return f"while it is marked a program can't import {root}; it can import {others}"


@contextmanager
def fenced(filename: str) -> Iterator[None]:
    """Inside this block the program of that name finds only what it may use."""
    real_import = builtins.__import__
    real_open = builtins.open

    def guarded(name: str, *rest: Any, **named: Any) -> Any:
        frame = sys._getframe(1)
        if frame.f_code.co_filename == filename:
            reason = why_not(name)
            if reason is not None:
                raise NotAllowedError(reason)
        return real_import(name, *rest, **named)

    def no_open(*_arguments: object, **_named: object) -> NoReturn:
        raise NotAllowedError("open() is not allowed: while it is marked a program has no files")

    hidden = {
        name: sys.modules.pop(name)
        for name in list(sys.modules)
        if name.partition(".")[0] in _HIDDEN
    }
    builtins.__import__ = guarded
    builtins.open = no_open
    try:
        yield
    finally:
        builtins.__import__ = real_import
        builtins.open = real_open
        sys.modules.update(hidden)
