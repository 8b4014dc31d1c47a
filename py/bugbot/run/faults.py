"""From an exception to what the learner is told: which line, what, and why perhaps.

May import: the standard library, `bugbot.errors`.
"""

from __future__ import annotations

import traceback
from dataclasses import dataclass

__all__ = ["Fault", "fault_of"]


@dataclass(frozen=True, slots=True)
class Fault:
    """An error of the learner's program, in the words of a trace's `fault` event."""

    type: str
    message: str
    line: int | None
    hint: str | None
    traceback: str


def fault_of(error: BaseException, filename: str) -> Fault:
    """What to tell of this error in the program `filename`."""
    line = None
    if isinstance(error, SyntaxError) and error.filename == filename:
        line = error.lineno
        message = error.msg
    else:
        for frame in traceback.extract_tb(error.__traceback__):
            if frame.filename == filename:
                line = frame.lineno
        message = str(error)
    return Fault(type(error).__name__, message, line, None, "")
