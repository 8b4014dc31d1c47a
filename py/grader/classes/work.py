"""One submission as work that can be sent to any process or machine, and the row it comes to.

May import: the standard library, the rest of `grader`.

A row is plain data (it goes through pipes, networks and files):

    {"learner", "lesson", "task", "file", "key",
     "status": "passed" | "failed" | "unreadable" | "not marked",
     "passed": checks passed, "of": checks,
     "failed": [{"title", "expected", "got", "likely", "hint"}, …],
     "score": null | {"value", "of"}, "note": null | text, "seconds": real seconds}

"unreadable" is the file's fault, "not marked" ours or the machine's; `note` says more of both.
"""

from __future__ import annotations

import atexit
import json
import time
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any, TypedDict

from grader.classes.submissions import Submission, UnreadableError, read_program
from grader.lesson import CourseError
from grader.marking import Performer, mark_program
from grader.marks import FAILED, PASSED
from sandbox.node import NoSandboxError, Sandbox, SandboxError

__all__ = [
    "FAILED_ROW",
    "NOT_MARKED",
    "PASSED_ROW",
    "UNREADABLE",
    "Failure",
    "Row",
    "Work",
    "close_performer",
    "mark_work",
    "not_marked",
    "source_key",
    "work_of",
]

PASSED_ROW = "passed"
FAILED_ROW = "failed"
UNREADABLE = "unreadable"
NOT_MARKED = "not marked"

_PY = Path(__file__).resolve().parents[2]
_PACKAGES = ("bugbot", "mapping", "performer", "grader")
_MOST_TEXT = 500
"""Characters of what a learner's program said that a report shows."""


class Failure(TypedDict):
    """A failed check."""

    title: str
    expected: str
    got: str
    likely: str | None
    hint: int | None


class Row(TypedDict):
    """What became of one submission."""

    learner: str
    lesson: str
    task: str
    file: str
    key: str
    status: str
    passed: int
    of: int
    failed: list[Failure]
    score: dict[str, float] | None
    note: str | None
    seconds: float


class Work(TypedDict):
    """A submission with all that marking it needs; `program` is null if it can't be read."""

    learner: str
    task: str
    file: str
    lesson: dict[str, Any]
    check: str
    program: str | None
    note: str | None
    trusted: bool
    sources: str
    key: str


@cache
def source_key() -> str:
    """A hash over the Python that marks: the same on two machines if theirs is the same."""
    hashed = sha256()
    for package in _PACKAGES:
        for path in sorted((_PY / package).rglob("*")):
            if path.suffix in (".py", ".json") and "classes" not in path.parts:
                hashed.update(path.relative_to(_PY).as_posix().encode() + b"\0")
                hashed.update(path.read_bytes() + b"\0")
    return hashed.hexdigest()[:16]


def work_of(submission: Submission, *, trusted: bool) -> Work:
    """Read a submission and put all that its marking needs beside it."""
    program: str | None = None
    note: str | None = None
    try:
        program = read_program(submission.path)
    except UnreadableError as error:
        note = str(error)
    lesson = submission.lesson.for_judge()
    check = submission.task.check.read_text("utf-8")
    parts = [lesson, submission.task.name, check, program, note, trusted, source_key()]
    key = sha256(json.dumps(parts).encode("utf-8", "surrogatepass")).hexdigest()
    return {
        "learner": submission.learner,
        "task": submission.task.name,
        "file": submission.name,
        "lesson": lesson,
        "check": check,
        "program": program,
        "note": note,
        "trusted": trusted,
        "sources": source_key(),
        "key": key,
    }


def mark_work(work: Work) -> Row:
    """Mark one submission, here; never raises for what is in the file."""
    program = work["program"]
    if program is None:
        return {**_row(work), "status": UNREADABLE, "note": work["note"]}
    if work["sources"] != source_key():
        return not_marked(
            work, "this machine has another version of the project: bring it up to date"
        )
    began = time.perf_counter()
    try:
        mark = mark_program(
            work["check"], work["lesson"], work["task"], program, _perform(work["trusted"])
        )
    except (CourseError, NoSandboxError, SandboxError) as error:
        return not_marked(work, str(error))
    row = _marked(work, mark)
    row["seconds"] = round(time.perf_counter() - began, 2)
    return row


def not_marked(work: Work, why: str) -> Row:
    """The row of a submission that could not be marked, for no fault of the file."""
    return {**_row(work), "note": _shown(why)}


def close_performer() -> None:
    """End whatever this process has started for its markings."""
    for trusted in (True, False):
        if trusted in _performers:
            _performers.pop(trusted).close()


_performers: dict[bool, Performer | Sandbox] = {}
atexit.register(close_performer)


def _perform(trusted: bool) -> Any:
    if trusted not in _performers:
        _performers[trusted] = Performer() if trusted else Sandbox()
    return _performers[trusted].perform


def _row(work: Work) -> Row:
    return {
        "learner": work["learner"],
        "lesson": work["lesson"]["slug"],
        "task": work["task"],
        "file": work["file"],
        "key": work["key"],
        "status": NOT_MARKED,
        "passed": 0,
        "of": 0,
        "failed": [],
        "score": None,
        "note": None,
        "seconds": 0.0,
    }


def _marked(work: Work, mark: dict[str, Any]) -> Row:
    row = _row(work)
    if mark["ours"] is not None:
        return {**row, "note": _shown(mark["ours"])}
    checks = mark["checks"]
    score = mark["score"]
    return {
        **row,
        "status": PASSED_ROW if mark["passed"] else FAILED_ROW,
        "passed": sum(each["status"] == PASSED for each in checks),
        "of": len(checks),
        "failed": [_failure(each) for each in checks if each["status"] == FAILED],
        "score": None if score is None else {"value": score["value"], "of": score["of"]},
    }


def _failure(check: dict[str, Any]) -> Failure:
    likely = check["likely"]
    return {
        "title": check["title"],
        "expected": _shown(check["expected"]),
        "got": _shown(check["got"]),
        "likely": None if likely is None else _shown(likely),
        "hint": check["hint"],
    }


def _shown(text: str) -> str:
    """A text as reports show it: not too long, without the characters that steer a screen."""
    plain = "".join(each if each.isprintable() or each == "\n" else "�" for each in text)
    return plain if len(plain) <= _MOST_TEXT else plain[: _MOST_TEXT - 1] + "…"
