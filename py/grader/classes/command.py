"""python -m grader mark-all FOLDER: marks a class's files.

May import: the standard library, `grader`.

Writes, into FOLDER-marks beside the folder (or --out): marks.csv, report.html, and rows.jsonl,
by which a marking that was stopped goes on. Ends with 0 if every submission has a mark, with 1
if some have none for no fault of the files, with 2 for wrong usage, with 130 after Ctrl-C.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections import Counter
from collections.abc import Callable, Generator, Sequence
from contextlib import closing
from pathlib import Path
from typing import TextIO

from bugbot.errors import counted
from bugbot.plain_text import plain
from grader.classes.lanes import by_processes
from grader.classes.machines import by_machines
from grader.classes.page import page_of
from grader.classes.record import Record
from grader.classes.submissions import Found, find
from grader.classes.summary import STATUSES, in_order, totals
from grader.classes.table import csv_of
from grader.classes.work import NOT_MARKED, Row, Work, work_of
from grader.lesson import CourseError, Lesson, course, lesson_at, name_of_lesson
from sandbox.node import prepared

__all__ = ["add_arguments", "mark_all"]

_STOPPED = 130
_USAGE = 2

_SHAPE = """
the folder's shape:
  FOLDER/LEARNER/TASK.py, FOLDER/LEARNER--TASK.py, or FOLDER/LEARNER.py with --task;
  FOLDER/LEARNER/LESSON/TASK.py where two lessons have a task of that name.
A file whose name does not fit is listed in the report and not marked.
"""


def add_arguments(parser: argparse.ArgumentParser, count: Callable[[str], int]) -> None:
    """The arguments of mark-all; `count` reads a whole number from 1."""
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _SHAPE
    parser.add_argument("folder", metavar="FOLDER", type=Path, help="holds the class's files")
    parser.add_argument(
        "--lesson", metavar="LESSON", type=name_of_lesson, help="mark the tasks of this lesson only"
    )
    parser.add_argument("--task", metavar="TASK", help="mark this task only")
    parser.add_argument("--out", metavar="DIR", type=Path, help="where to write (FOLDER-marks)")
    parser.add_argument("--again", action="store_true", help="mark all anew, nothing from before")
    parser.add_argument(
        "--trusted",
        action="store_true",
        help="mark in plain CPython processes: quicker, but a file can do whatever you can, "
        "read and delete your files and change others' marks among it",
    )
    where = parser.add_mutually_exclusive_group()
    where.add_argument(
        "--processes",
        type=count,
        default=os.cpu_count() or 1,
        help="markings done side by side on this machine (as many as it has cores)",
    )
    where.add_argument("--dask", metavar="ADDRESS", help="mark on the workers of this scheduler")


def mark_all(options: argparse.Namespace) -> int:
    """Do it; returns the exit status."""
    began = time.perf_counter()
    lessons = _lessons(options.lessons)
    folder: Path = options.folder
    found = find(folder, lessons, lesson=options.lesson, task=options.task)
    out: Path = options.out or folder.resolve().with_name(f"{folder.resolve().name}-marks")
    _make_folder(out)
    if not options.trusted:
        prepared()
    works = [work_of(each, trusted=options.trusted) for each in found.submissions]
    tasks = [(lesson.slug, task.name) for lesson in lessons for task in lesson.tasks]
    rows: list[Row] = []
    stopped = False
    unwritten: list[str] = []
    with _record(out / "rows.jsonl", options.again) as record:
        waiting = []
        for work in works:
            row = record.earlier(work["file"], work["key"])
            if row is None:
                waiting.append(work)
            else:
                rows.append(row)
        shown = _Progress(sys.stderr, len(works), len(rows))
        try:
            with closing(_marked(waiting, options)) as coming:
                for row in coming:
                    rows.append(row)
                    record.add(row)
                    shown.tell(row)
        except KeyboardInterrupt:
            stopped = True
        except OSError as error:  # of the record: markings tell of their own troubles in a row
            unwritten.append(f"rows.jsonl could not be written: {error.strerror}")
        finally:
            shown.end()
    rows = in_order(rows, tasks)
    about = _about(options, found, rows, len(works), time.perf_counter() - began)
    page = page_of(rows, totals(rows, tasks), found.strays, about)
    # The byte-order mark is what spreadsheets want.
    for name, text, encoding in (
        ("marks.csv", csv_of(rows), "utf-8-sig"),
        ("report.html", page, "utf-8"),
    ):
        try:
            _write(out / name, text, encoding)
        except OSError as error:
            unwritten.append(f"{name} could not be written: {error.strerror}")
    if unwritten:
        print(plain("\n".join([*about, *unwritten, *_in_short(rows)])))
        return _USAGE
    print(plain("\n".join([*about, f"{out / 'report.html'} and marks.csv beside it tell more."])))
    if stopped:
        print("Stopped. The same command goes on from here.")
        return _STOPPED
    return 1 if any(row["status"] == NOT_MARKED for row in rows) else 0


def _lessons(folder: Path) -> list[Lesson]:
    slugs, faults = course(folder)
    if faults:
        raise CourseError(str(faults[0]))
    return [lesson_at(folder / slug) for slug in slugs]


def _marked(works: Sequence[Work], options: argparse.Namespace) -> Generator[Row, None, None]:
    if not works:
        return
    if options.dask is not None:
        yield from by_machines(works, options.dask)
    else:
        yield from by_processes(works, min(options.processes, len(works)))


def _write(path: Path, text: str, encoding: str) -> None:
    """Write beside and rename, so that there is the old file or the new one, never half of it."""
    beside = path.with_name(f"{path.name}.new")
    try:
        beside.write_text(text, encoding=encoding, errors="backslashreplace", newline="")
        beside.replace(path)
    except OSError:
        beside.unlink(missing_ok=True)
        raise


def _make_folder(out: Path) -> None:
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise CourseError(f"{out} can't be made: {error.strerror}") from None


def _record(path: Path, anew: bool) -> Record:
    try:
        return Record(path, anew=anew)
    except OSError as error:
        raise CourseError(f"{path} can't be written: {error.strerror}") from None


def _in_short(rows: Sequence[Row]) -> list[str]:
    """The marks for the screen, where no file would take them."""
    return [f"{row['learner']}  {row['lesson']}  {row['task']}  {row['status']}" for row in rows]


def _about(
    options: argparse.Namespace, found: Found, rows: Sequence[Row], of: int, seconds: float
) -> list[str]:
    count = Counter(row["status"] for row in rows)
    told = ", ".join(f"{count[each]} {each}" for each in STATUSES if count[each]) or "none"
    if options.trusted:
        where = "in plain CPython, as files that are trusted"
    elif options.dask is not None:
        where = "in the locked-down Python under Node"
    else:
        where = f"in the locked-down Python under Node ({prepared().walls.held})"
    folder = plain(str(options.folder), "")
    lines = [
        f"{folder}: {len(rows)} of {counted(of, 'submission')} {where}, {seconds:.1f} s: {told}."
    ]
    if found.left_out:
        lines.append(f"Of other tasks, left out as asked: {found.left_out}.")
    if found.strays:
        names = ", ".join(plain(each.name[:200], "") for each in found.strays[:5])
        more = "" if len(found.strays) <= 5 else f" and {len(found.strays) - 5} more"
        lines.append(f"Files that fit no task: {names}{more}.")
    return lines


class _Progress:
    """How far the marking is: a line that is rewritten on a screen, a line a tenth in a log."""

    def __init__(self, out: TextIO, of: int, done: int) -> None:
        self._out = out
        self._of = of
        self._done = self._before = done
        self._began = time.perf_counter()
        self._screen = out.isatty()
        self._open = False
        if done:
            out.write(f"{done} of {of} are marked already.\n")

    def tell(self, row: Row) -> None:
        self._done += 1
        tenth = self._done * 10 // self._of > (self._done - 1) * 10 // self._of
        if not self._screen and not tenth:
            return
        new = self._done - self._before
        left = (time.perf_counter() - self._began) / new * (self._of - self._done)
        line = (
            f"{self._done} of {self._of} marked, about {left:.0f} s left ({plain(row['file'], '')})"
        )
        if self._screen:
            self._out.write(f"\r{line[:78]:78}")
            self._open = True
        else:
            self._out.write(line + "\n")
        self._out.flush()

    def end(self) -> None:
        if self._open:
            self._out.write("\n")
