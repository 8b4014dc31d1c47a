"""The mark: JSON for the page; `grader.report` makes it text.

May import: the standard library, `grader.failures`.

    {"format": 1, "lesson", "task", "passed",
     "checks": [{"title", "status": "passed" | "failed" | "not run", "expected", "got",
                 "where": null | {"world", "cells", "cell_cm", "seconds", "job"},
                 "likely": null | text, "hint": null | 0 to 2}, …],
     "results": [{"check": its check's place, "world", "seed", "job",
                  "layers": {"free", "occupied"}: names of the layers that hold its map,
                  "ended": "finished" | "limit" | "fault" | "stopped" | "doubted" | "died",
                  "why": why it stopped, as the program or the limit says,
                  "figures": [{"name", "value": null | number, "unit", "digits",
                               "at_least": null | number, "at_most": null | number,
                               "met": null | bool}, …],
                  "points": null | number, "passed",
                  "map": null | {"across", "cell_cm", "cells": a letter each (`grader.results`)},
                  "path": [[x, y], …]}, …],
     "score": null | {"value", "of", "how": what counts, in words},
     "ours": null | text}

`results` are the runs that checks asked for as trials, and `score` what these are worth together.

`ours` is a fault of the lesson or of the grader. It is never the learner's, and says so.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from grader.failures import ArgumentChanged, CheckFailed, ProgramFailed

__all__ = [
    "FAILED",
    "NOT_RUN",
    "PASSED",
    "entry",
    "failed_entry",
    "first_failed",
    "mark_of",
]

PASSED = "passed"
FAILED = "failed"
NOT_RUN = "not run"


def entry(title: str, status: str) -> dict[str, Any]:
    """A check in a mark, without details."""
    return {
        "title": title,
        "status": status,
        "expected": None,
        "got": None,
        "where": None,
        "likely": None,
        "hint": None,
    }


def failed_entry(title: str, failure: CheckFailed, hint: int | None) -> dict[str, Any]:
    """A failed check in a mark; `hint` is the check's own, if the failure names none.

    A program that does not even run, or changes what it is given, is not helped by a hint about
    what it should compute.
    """
    if isinstance(failure, ProgramFailed | ArgumentChanged):
        hint = None
    return {
        **entry(title, FAILED),
        "expected": failure.expected,
        "got": failure.got,
        "where": failure.where,
        "likely": failure.likely,
        "hint": hint if failure.hint is None else failure.hint,
    }


def mark_of(
    lesson: str,
    task: str,
    checks: list[dict[str, Any]],
    *,
    results: Sequence[dict[str, Any]] = (),
    score: dict[str, Any] | None = None,
    ours: str | None = None,
) -> dict[str, Any]:
    """The whole mark."""
    passed = ours is None and bool(checks) and all(each["status"] == PASSED for each in checks)
    return {
        "format": 1,
        "lesson": lesson,
        "task": task,
        "passed": passed,
        "checks": checks,
        "results": list(results),
        "score": score,
        "ours": ours,
    }


def first_failed(mark: dict[str, Any]) -> dict[str, Any] | None:
    """The check whose details are worth reading first."""
    return next((each for each in mark["checks"] if each["status"] == FAILED), None)
