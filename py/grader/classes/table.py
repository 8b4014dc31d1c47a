"""The marks as CSV, one submission a line: for a spreadsheet or a gradebook.

May import: the standard library, `grader.classes.work`.

What a program printed or a learner called a file may be made to look like a formula; a
spreadsheet would carry it out when the file is opened. Such a text gets an apostrophe in front.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable

from grader.classes.work import Row

__all__ = ["csv_of"]

COLUMNS = (
    *("learner", "lesson", "task", "file", "status", "checks passed", "checks"),
    *("score", "failed check", "expected", "got", "likely mistake", "hint", "note", "seconds"),
)

_BEGINS_A_FORMULA = ("=", "+", "-", "@", "\t", "\r")


def csv_of(rows: Iterable[Row]) -> str:
    """The table; of several failed checks the first, which is the one a learner is shown."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for row in rows:
        writer.writerow(_safe(cell) for cell in _cells(row))
    return text.getvalue()


def _cells(row: Row) -> list[str | int | float | None]:
    told: list[str | int | None] = [None] * 5
    if row["failed"]:
        first = row["failed"][0]
        hint = None if first["hint"] is None else first["hint"] + 1
        told = [first["title"], first["expected"], first["got"], first["likely"], hint]
    return [
        *(row["learner"], row["lesson"], row["task"], row["file"], row["status"]),
        *(row["passed"], row["of"]),
        None if row["score"] is None else row["score"]["value"],
        *told,
        *(row["note"], row["seconds"]),
    ]


def _safe(cell: str | int | float | None) -> str | int | float | None:
    if isinstance(cell, str) and cell.startswith(_BEGINS_A_FORMULA):
        return f"'{cell}"
    return cell
