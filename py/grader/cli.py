"""The command line: mark a program or a class's, check a lesson or the whole course.

May import: the rest of `grader`.

    python -m grader mark LESSON TASK FILE [--part] [--trusted] [--json]
    python -m grader mark-all FOLDER [--processes N | --dask ADDRESS] [--trusted]
    python -m grader check [LESSON …] [--seeds N] [--one-in N]
    python -m grader mutants [LESSON [TASK]] [--sample N] [--list]

`mark` and `mark-all` run a file in a sandbox, where it can reach nothing of this machine, unless
they are told --trusted; `check` and `mutants` run the lessons' own files and go without.

Ends with 0 if the program passes or all is well, with 1 if not, with 2 for wrong usage or a
fault of ours.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

from bugbot.errors import counted
from bugbot.plain_text import json_text, plain
from grader.classes.command import add_arguments, mark_all
from grader.lesson import LESSONS, CourseError, TaskFolder, lesson_at, name_of_lesson
from grader.marking import Performer, mark_program
from grader.mutants import command as mutants_command
from grader.parts import PartError, compose
from grader.report import text_of
from grader.standing import SEEDS, Report, check_course
from sandbox.node import NoSandboxError, Sandbox, SandboxError

__all__ = ["main"]

_USAGE = 2


def main(arguments: list[str]) -> int:
    """Do what the arguments say; returns the exit status."""
    options = _parser().parse_args(arguments)
    try:
        if options.command == "mark":
            return _mark(options)
        if options.command == "mark-all":
            return mark_all(options)
        if options.command == "mutants":
            return mutants_command.mutants(options)
        return _check(options)
    except (CourseError, NoSandboxError, SandboxError) as error:
        print(plain(f"grader: {error}"), file=sys.stderr)
        return _USAGE


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m grader", description="Mark programs and check lessons."
    )
    commands = parser.add_subparsers(
        dest="command", required=True, metavar="mark|mark-all|check|mutants"
    )
    mark = commands.add_parser("mark", help="mark a program")
    mark.add_argument(
        "lesson", metavar="LESSON", type=name_of_lesson, help="the name of a lesson's folder"
    )
    mark.add_argument("task", metavar="TASK", help="the name of the task")
    mark.add_argument("file", metavar="FILE", help="the program's file; - reads standard input")
    mark.add_argument(
        "--trusted",
        action="store_true",
        help="run it in plain CPython: quicker, but the program can do whatever you can do",
    )
    mark.add_argument("--json", action="store_true", help="print the mark as JSON, only that")
    mark.add_argument(
        "--part", action="store_true", help="the file holds the learner's part, as those of right/"
    )
    whole = commands.add_parser("mark-all", help="mark the files of a whole class")
    add_arguments(whole, _count)
    check = commands.add_parser("check", help="check one lesson, or all of the course")
    check.add_argument(
        "lesson",
        nargs="*",
        metavar="LESSON",
        type=name_of_lesson,
        help="the names of lessons' folders",
    )
    check.add_argument(
        "--seeds", type=_count, default=SEEDS, help=f"noises a solution must pass on ({SEEDS})"
    )
    check.add_argument(
        "--one-in", type=_count, default=1, help="mark one in so many right and wrong programs (1)"
    )
    check.add_argument(
        "--processes", type=_count, default=2, help="markings done at the same time (2)"
    )
    mutants = commands.add_parser("mutants", help="change solutions a little: each must fail")
    mutants_command.add_arguments(mutants, _count)
    for each in (mark, whole, check, mutants):
        each.add_argument(
            "--lessons", type=Path, default=LESSONS, help="the folder that holds course.json"
        )
    return parser


def _count(text: str) -> int:
    number = int(text)
    if not 1 <= number <= 1000:
        raise argparse.ArgumentTypeError(f"a whole number from 1 to 1000 is wanted, not {text}")
    return number


def _mark(options: argparse.Namespace) -> int:
    lesson = lesson_at(options.lessons / options.lesson)
    task = lesson.task(options.task)
    program = _program(options.file)
    if options.part:
        program = _composed(task, program)
    with Performer() if options.trusted else Sandbox() as performer:
        mark = mark_program(
            task.check.read_text("utf-8"),
            lesson.for_judge(),
            task.name,
            program,
            performer.perform,
        )
    print(json_text(mark) if options.json else plain(text_of(mark)))
    if mark["ours"] is not None:
        return _USAGE
    return 0 if mark["passed"] else 1


def _composed(task: TaskFolder, part: str) -> str:
    try:
        return compose(task.starter.read_text("utf-8"), part)
    except PartError as error:
        raise CourseError(f"{task.starter}: {error}") from None


def _program(file: str) -> str:
    try:
        if file == "-":
            return sys.stdin.read()
        return Path(file).read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise CourseError(f"can't read {file}: {error.strerror}") from None


# -- check -----------------------------------------------------------------------

_COLUMNS = (
    "tasks",
    "checks",
    "starters fail",
    "solutions pass",
    "right pass",
    "wrong earn",
    "seconds",
)


def _check(options: argparse.Namespace) -> int:
    began = time.perf_counter()
    reports = check_course(
        options.lessons,
        options.lesson,
        seeds=options.seeds,
        one_in=options.one_in,
        processes=options.processes,
    )
    print(f"{'lesson':34}" + "".join(f"{name:>16}" for name in _COLUMNS))
    for report in reports:
        print(_row(report))
    faults = [fault for report in reports for fault in report.faults]
    for fault in faults:
        print(f"\n{fault}")
    seconds = time.perf_counter() - began
    said = "all is well" if not faults else f"{counted(len(faults), 'fault')}"
    print(f"\n{counted(len(reports), 'lesson')} in {seconds:.1f} s: {said}")
    return 1 if faults else 0


def _row(report: Report) -> str:
    values = (
        report.tasks,
        report.checks,
        report.starters,
        report.solutions,
        report.right,
        report.wrong,
        f"{report.seconds:.1f}",
    )
    return f"{report.slug:34}" + "".join(f"{value:>16}" for value in values)
