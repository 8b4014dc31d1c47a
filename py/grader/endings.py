"""How a run ended: whether it can be judged, and if not, why.

May import: the standard library, `bugbot`, `grader.failures`, `grader.functions`, `grader.trust`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from bugbot.trace import Trace
from bugbot.worlds import World
from grader.failures import ProgramFailed
from grader.functions import fault_text
from grader.trust import doubt

__all__ = ["Ending", "broken_off", "ending_of", "where_in"]


@dataclass(frozen=True, slots=True)
class Ending:
    """How a run ended.

    kind     as its trace says: finished, fault, limit or stopped; doubted, if it can't have
             happened; died, if it left no trace
    trouble  what keeps it from being judged; None if nothing does
    """

    kind: str
    trouble: ProgramFailed | None


def ending_of(job: dict[str, Any], trace: Trace) -> Ending:
    """How a run that left a trace ended."""
    fault = next(trace.of_kind("fault"), None)
    end = next(trace.of_kind("end"))
    if fault is not None:
        words = "a program that runs without an error"
        trouble = _failed(words, fault_text(fault), job, fault["t"], fault["hint"])
        return Ending("fault", trouble)
    if end["status"] != "finished":
        limit = job["limits"]["simulated_s"]
        words = f"a program that comes to its end, within {limit:g} simulated seconds"
        return Ending(end["status"], _failed(words, end["message"], job, end["t"]))
    found = doubt(trace, World.from_dict(job["world"]))
    if found is not None:
        reason, seconds = found
        words = "a run that the robot could have made"
        got = f"{reason} (at {seconds:.2f} s)"
        likely = "the program reaches past the robot's calls, to what lies behind them"
        return Ending("doubted", _failed(words, got, job, seconds, likely))
    return Ending("finished", None)


def broken_off(job: dict[str, Any], expected: str, got: str) -> Ending:
    """The ending of a run that left no trace to look at."""
    return Ending("died", _failed(expected, got, job))


def _failed(
    expected: str,
    got: str,
    job: dict[str, Any],
    seconds: float | None = None,
    likely: str | None = None,
) -> ProgramFailed:
    return ProgramFailed(expected, got[:600], likely=likely, where=where_in(job, seconds))


def where_in(
    job: dict[str, Any],
    seconds: float | None,
    cells: Iterable[Sequence[int]] = (),
    cell_cm: float = 5.0,
) -> dict[str, Any]:
    """Where on the mat, as a mark holds it."""
    return {
        "world": job["world"],
        "cells": [list(cell) for cell in cells],
        "cell_cm": cell_cm,
        "seconds": seconds,
        "job": job["id"],
    }
