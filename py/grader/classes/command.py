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

from grader.classes.lanes import by_processes
from grader.classes.machines import by_machines
from grader.classes.page import page_of
from grader.classes.record import Record
from grader.classes.sandbox import prepared
from grader.classes.submissions import Found, find
from grader.classes.summary import STATUSES, in_order, totals
from grader.classes.table import csv_of
from grader.classes.work import NOT_MARKED, Row, Work, work_of
from grader.lesson import CourseError, Lesson, course, lesson_at

__all__ = ["add_arguments", "mark_all"]

_STOPPED = 130

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
    parser.add_argument("--lesson", metavar="LESSON", help="mark the tasks of this lesson only")
    parser.add_argument("--task", metavar="TASK", help="mark this task only")
    parser.add_argument("--out", metavar="DIR", type=Path, help="where to write (FOLDER-marks)")
    parser.add_argument("--again", action="store_true", help="mark all anew, nothing from before")
    parser.add_argument(
        "--trusted",
        action="store_true",
        help="mark in plain CPython processes: quicker, but the files can do what you can",
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
    out.mkdir(parents=True, exist_ok=True)
    if not options.trusted:
        prepared()
    works = [work_of(each, trusted=options.trusted) for each in found.submissions]
    tasks = [(lesson.slug, task.name) for lesson in lessons for task in lesson.tasks]
    rows: list[Row] = []
    stopped = False
    with Record(out / "rows.jsonl", anew=options.again) as record:
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
                    record.add(row)
                    rows.append(row)
                    shown.tell(row)
        except KeyboardInterrupt:
            stopped = True
        finally:
            shown.end()
    rows = in_order(rows, tasks)
    about = _about(options, found, rows, len(works), time.perf_counter() - began)
    _write(out / "marks.csv", csv_of(rows), "utf-8-sig")  # as spreadsheets want it
    _write(out / "report.html", page_of(rows, totals(rows, tasks), found.strays, about), "utf-8")
    print("\n".join([*about, f"{out / 'report.html'} and marks.csv beside it tell more."]))
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
    path.write_text(text, encoding=encoding, errors="backslashreplace", newline="")


def _about(
    options: argparse.Namespace, found: Found, rows: Sequence[Row], of: int, seconds: float
) -> list[str]:
    count = Counter(row["status"] for row in rows)
    told = ", ".join(f"{count[each]} {each}" for each in STATUSES if count[each]) or "none"
    where = "in the locked-down Python under Node"
    if options.trusted:
        where = "in plain CPython, as files that are trusted"
    lines = [f"{options.folder}: {len(rows)} of {of} submissions {where}, {seconds:.1f} s: {told}."]
    if found.left_out:
        lines.append(f"Of other tasks, left out as asked: {found.left_out}.")
    if found.strays:
        names = ", ".join(each.name for each in found.strays[:5])
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
        line = f"{self._done} of {self._of} marked, about {left:.0f} s left ({row['file']})"
        if self._screen:
            self._out.write(f"\r{line[:78]:78}")
            self._open = True
        else:
            self._out.write(line + "\n")
        self._out.flush()

    def end(self) -> None:
        if self._open:
            self._out.write("\n")
