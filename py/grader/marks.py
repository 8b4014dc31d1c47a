"""The mark: JSON for the page, text for the command line.

May import: the standard library, `grader.failures`.

    {"format": 1, "lesson", "task", "passed",
     "checks": [{"title", "status": "passed" | "failed" | "not run", "expected", "got",
                 "where": null | {"world", "cells", "cell_cm", "seconds", "job"},
                 "likely": null | text, "hint": null | 0 to 2}, …],
     "ours": null | text}

`ours` is a fault of the lesson or of the grader. It is never the learner's, and says so.
"""

from __future__ import annotations

from typing import Any

from grader.failures import CheckFailed, ProgramFailed

__all__ = [
    "FAILED",
    "NOT_RUN",
    "PASSED",
    "entry",
    "failed_entry",
    "first_failed",
    "mark_of",
    "text_of",
]

PASSED = "passed"
FAILED = "failed"
NOT_RUN = "not run"

_SIGNS = {PASSED: "+", FAILED: "-", NOT_RUN: "."}


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

    A program that does not even run is not helped by a hint about what it should compute.
    """
    if isinstance(failure, ProgramFailed):
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
    lesson: str, task: str, checks: list[dict[str, Any]], ours: str | None = None
) -> dict[str, Any]:
    """The whole mark."""
    passed = ours is None and bool(checks) and all(each["status"] == PASSED for each in checks)
    return {
        "format": 1,
        "lesson": lesson,
        "task": task,
        "passed": passed,
        "checks": checks,
        "ours": ours,
    }


def first_failed(mark: dict[str, Any]) -> dict[str, Any] | None:
    """The check whose details are worth reading first."""
    return next((each for each in mark["checks"] if each["status"] == FAILED), None)


def text_of(mark: dict[str, Any]) -> str:
    """The mark as the command line prints it."""
    lines = [f"{mark['lesson']}: {mark['task']}"]
    first = first_failed(mark)
    for each in mark["checks"]:
        lines.append(f"  {_SIGNS[each['status']]} {each['title']}: {each['status']}")
        if first is not None and each is first:
            lines += _details(first)
    if mark["ours"] is not None:
        lines.append(f"  This is our fault, not yours: {mark['ours']}")
    lines.append("Passed." if mark["passed"] else "Not passed yet.")
    return "\n".join(lines)


def _details(check: dict[str, Any]) -> list[str]:
    lines = [f"      expected: {check['expected']}", f"      got:      {check['got']}"]
    where = check["where"]
    if where is not None:
        parts = [f"world {where['world']['name']}"]
        if where["seconds"] is not None:
            parts.append(f"at {where['seconds']:.1f} s")
        if where["cells"]:
            cells = ", ".join(f"({column}, {row})" for column, row in where["cells"][:5])
            more = len(where["cells"]) - 5
            parts.append(f"cells {cells}{f' and {more} more' if more > 0 else ''}")
        lines.append(f"      where:    {'; '.join(parts)}")
    if check["likely"] is not None:
        lines.append(f"      likely:   {check['likely']}")
    if check["hint"] is not None:
        lines.append(f"      help:     hint {check['hint'] + 1}")
    return lines
