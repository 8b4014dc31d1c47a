"""What is marked already, kept while it is marked, so that a marking that was stopped can go on.

May import: the standard library, `grader.classes.work`.

One row as JSON a line. A row counts again only if nothing that it depends on has changed: the
program, the check, the lesson's worlds, the Python that marks, and how (its `key`).
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path
from types import TracebackType

from grader.classes.work import NOT_MARKED, Row

__all__ = ["Record"]


class Record:
    """The file of rows. Use it in a `with` block."""

    def __init__(self, path: Path, *, anew: bool = False) -> None:
        self._path = path
        self._rows = {} if anew else {(row["file"], row["key"]): row for row in _read(path)}
        self._file = path.open("w", encoding="utf-8")
        for row in self._rows.values():
            self._write(row)

    def __enter__(self) -> Record:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._file.close()

    def earlier(self, file: str, key: str) -> Row | None:
        """The row of that file from an earlier marking, if it still holds."""
        return self._rows.get((file, key))

    def add(self, row: Row) -> None:
        """Keep a row, at once."""
        if row["status"] != NOT_MARKED:  # another time it may be
            self._write(row)
            self._file.flush()

    def _write(self, row: Row) -> None:
        self._file.write(json.dumps(row) + "\n")


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
