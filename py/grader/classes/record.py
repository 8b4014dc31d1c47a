"""What is marked already, kept while it is marked, so that a marking that was stopped can go on.

May import: the standard library, `grader.classes.work`.

One row as JSON a line. A row counts again only if nothing that it depends on has changed: the
program, the check, the lesson's worlds, the Python that marks, and how (its `key`).
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from types import TracebackType

from grader.classes.work import NOT_MARKED, Row

__all__ = ["Record"]


class Record:
    """The file of rows. Use it in a `with` block."""

    def __init__(self, path: Path, *, anew: bool = False) -> None:
        self._path = path
        self._rows = {} if anew else {(row["file"], row["key"]): row for row in _read(path)}
        # Written beside and renamed: whoever stops it here still has the old rows.
        beside = path.with_name(f"{path.name}.new")
        with beside.open("w", encoding="utf-8") as file:
            file.writelines(_line(row) for row in self._rows.values())
        beside.replace(path)
        self._file = path.open("a", encoding="utf-8")

    def __enter__(self) -> Record:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        with suppress(OSError):  # a disk that is full has been told of already
            self._file.close()

    def earlier(self, file: str, key: str) -> Row | None:
        """The row of that file from an earlier marking, if it still holds."""
        return self._rows.get((file, key))

    def add(self, row: Row) -> None:
        """Keep a row, at once; raises OSError if it can't be written."""
        if row["status"] != NOT_MARKED:  # another time it may be
            self._file.write(_line(row))
            self._file.flush()


def _line(row: Row) -> str:
    return json.dumps(row) + "\n"


def _read(path: Path) -> Iterable[Row]:
    try:
        lines = path.read_text("utf-8").splitlines()
    except (OSError, UnicodeDecodeError):
        return
    for line in lines:
        try:
            row = json.loads(line)
        except ValueError:
            continue  # cut short, by a stop in the middle of it
        if isinstance(row, dict) and Row.__required_keys__ <= row.keys():
            yield row  # type: ignore[misc]  # a file of our own; its keys are looked at
