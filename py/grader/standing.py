"""The standing check of a course: what must hold of every lesson before it is published.

May import: the standard library, the rest of `grader`.

Of each task: the starter fails, the solution and the right ones in other styles pass on 20
different noises, each wrong attempt fails and earns the message that its first line names. Every
hint that a check points to is there.
A hidden world has the robot start where the task's own world has it, because a program's
position() counts from there. And all that `grader.lesson` finds wrong with the folder.

The markings are shared out among a few processes; each keeps a performer of its own.
"""

from __future__ import annotations

import atexit
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any
from zlib import crc32

from grader.lesson import CourseError, Fault, Lesson, TaskFolder, course, lesson_at
from grader.marking import Performer, mark_program
from grader.marks import first_failed
from grader.parts import PartError, compose

__all__ = ["SEEDS", "Report", "check_course"]

SEEDS = 20
"""On so many noises each solution must pass."""

_SHIFT = 1000
"""Between the seeds of one noise and the next."""

_AT_ONCE = 5
"""So many markings of one solution are handed to a process together."""


@dataclass(frozen=True, slots=True)
class _Part:
    """Work for one process: one program, marked on some noises."""

    lesson: Path
    task: str
    kind: str
    """starter, solution, right or wrong"""
    program: Path
    shifts: tuple[int, ...]
    earns: str = ""


@dataclass(slots=True)
class Report:
    """What the check of one lesson came to."""

    slug: str
    tasks: int = 0
    checks: int = 0
    starters: int = 0
    solutions: int = 0
    right: int = 0
    wrong: int = 0
    seconds: float = 0.0
    faults: list[Fault] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class _Found:
    """What one part of the work came to."""

    slug: str
    kind: str
    marked: int
    checks: int
    seconds: float
    faults: tuple[Fault, ...]


def check_course(
    folder: Path,
    only: Sequence[str] = (),
    *,
    seeds: int = SEEDS,
    one_in: int = 1,
    processes: int = 2,
) -> list[Report]:
    """Check the lessons of a course, or those named; one report each, in the course's order.

    With `one_in` above 1, only that share of the right and wrong programs is marked, always the
    same ones; starters and solutions all are.

    Faults of the course.json itself, and folders that it does not name, are in a report of
    their own at the beginning. A folder whose name begins with _ is no lesson.
    """
    slugs, faults = course(folder)
    reports = []
    if not only:
        own = Report("course.json", faults=faults)
        for path in sorted(folder.glob("*/lesson.json")):
            name = path.parent.name
            if not name.startswith("_") and name not in slugs and _has_tasks(path.parent):
                words = "course.json does not name this lesson: add it there, or remove it"
                own.faults.append(Fault(path, None, words))
        if own.faults:
            reports.append(own)
    lessons = [lesson_at(folder / slug) for slug in (only or slugs)]
    by_slug = {
        each.slug: Report(each.slug, len(each.tasks), faults=each.faults) for each in lessons
    }
    parts = [part for lesson in lessons for part in _parts(lesson, seeds, one_in)]
    with ProcessPoolExecutor(processes) as pool:
        for found in pool.map(_done, parts):
            report = by_slug[found.slug]
            report.seconds += found.seconds
            report.faults += found.faults
            report.checks += found.checks
            report.starters += found.marked if found.kind == "starter" else 0
            report.solutions += found.marked if found.kind == "solution" else 0
            report.right += found.marked if found.kind == "right" else 0
            report.wrong += found.marked if found.kind == "wrong" else 0
    return [*reports, *by_slug.values()]


def _has_tasks(path: Path) -> bool:
    return any(path.glob("*/check.py"))


def _parts(lesson: Lesson, seeds: int, one_in: int) -> Iterator[_Part]:
    for task in lesson.tasks:
        yield _Part(lesson.path, task.name, "starter", task.starter, (0,))
        shifts = [_SHIFT * number for number in range(seeds)]
        right = [path for path in task.right if _is_chosen(path, one_in)]
        passing = [("solution", task.solution), *(("right", path) for path in right)]
        for kind, program in passing:
            for first in range(0, seeds, _AT_ONCE):
                some = tuple(shifts[first : first + _AT_ONCE])
                yield _Part(lesson.path, task.name, kind, program, some)
        for attempt in task.wrong:
            if not _is_chosen(attempt.path, one_in):
                continue
            yield _Part(lesson.path, task.name, "wrong", attempt.path, (0,), attempt.earns)


def _is_chosen(program: Path, one_in: int) -> bool:
    """Whether a program is in the share; by its name and its folder's, so that it stays in it."""
    name = f"{program.parent.parent.name}/{program.parent.name}/{program.name}"
    return crc32(name.encode()) % one_in == 0


# -- in a process of its own -----------------------------------------------------


@cache
def _performer() -> Performer:
    performer = Performer()
    atexit.register(performer.close)
    return performer


@cache
def _lesson(path: Path) -> Lesson:
    return lesson_at(path)


def _done(part: _Part) -> _Found:
    began = time.perf_counter()
    lesson = _lesson(part.lesson)
    task = lesson.task(part.task)
    faults: list[Fault] = []
    checks = 0
    for shift in part.shifts:
        mark, worlds = _marked(lesson, task, part, shift)
        faults += _judged(part, task, mark, shift)
        if part.kind == "solution" and shift == 0:
            checks = len(mark["checks"])
            faults += _wrong_starts(lesson, task, worlds)
    seconds = time.perf_counter() - began
    return _Found(lesson.slug, part.kind, len(part.shifts), checks, seconds, tuple(faults))


def _marked(
    lesson: Lesson, task: TaskFolder, part: _Part, shift: int
) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    """The mark of a program, and the worlds that it was run on."""
    worlds = []

    def perform(job: dict[str, Any], source: str) -> dict[str, Any]:
        if job["kind"] == "run":
            worlds.append(job["world"])
        return _performer().perform(job, source)

    mark = mark_program(
        task.check.read_text("utf-8"),
        lesson.for_judge(),
        task.name,
        _complete(task, part.program),
        perform,
        shift=shift,
        until_failed=part.kind in ("starter", "wrong"),
    )
    return mark, worlds


def _complete(task: TaskFolder, program: Path) -> str:
    """The text that is marked: of a part, the complete program."""
    text = program.read_text("utf-8")
    if program not in task.right:
        return text
    try:
        return compose(task.starter.read_text("utf-8"), text)
    except PartError as error:
        raise CourseError(f"{task.starter}: {error}") from None


def _judged(part: _Part, task: TaskFolder, mark: dict[str, Any], shift: int) -> list[Fault]:
    """What is wrong with a mark, given whose it is."""
    if mark["ours"] is not None:
        return [Fault(part.program, None, f"marking it failed: {mark['ours']}")]
    failed = first_failed(mark)
    if failed is None:
        if part.kind in ("solution", "right"):
            return []
        return [Fault(part.program, None, f"the {_named(part.kind)} passes; it should fail")]
    told = _told(failed)
    if part.kind in ("solution", "right"):
        noise = "" if shift == 0 else f" with seeds {shift} higher"
        return [Fault(part.program, None, f"the {_named(part.kind)} fails{noise}: {told}")]
    hint = failed["hint"]
    if hint is not None and not 0 <= hint < task.hints:
        words = (
            f"the check {failed['title']!r} points to hint {hint}; there are 0 to {task.hints - 1}"
        )
        return [Fault(task.check, None, words)]
    earned = failed["likely"] if failed["likely"] is not None else failed["got"]
    if part.kind == "wrong" and part.earns not in earned:
        return [Fault(part.program, 1, f"should earn {part.earns!r}, but {_earned(failed)}")]
    return []


def _named(kind: str) -> str:
    return {"wrong": "wrong attempt", "right": "right solution"}.get(kind, kind)


def _told(failed: dict[str, Any]) -> str:
    likely = "" if failed["likely"] is None else f" ({failed['likely']})"
    return f"{failed['title']}: expected {failed['expected']}, got {failed['got']}{likely}"


def _earned(failed: dict[str, Any]) -> str:
    """What a wrong attempt earns, and only that: the text that its first line is held against."""
    told = f"the check {failed['title']!r}"
    if failed["likely"] is not None:
        return f"{told} names the mistake {failed['likely']!r}"
    return f"{told} names no mistake; it got {failed['got']!r}"


def _wrong_starts(
    lesson: Lesson, task: TaskFolder, worlds: list[dict[str, Any]]
) -> Iterator[Fault]:
    own = lesson.world(task.world)
    if own is None:
        raise CourseError(f"{lesson.slug} has no world {task.world!r}")
    x, y = own["start"]["x"], own["start"]["y"]
    for world in worlds:
        start = world["start"]
        if (start["x"], start["y"]) != (x, y):
            yield Fault(
                task.check,
                None,
                f"in the world {world['name']} the robot starts at ({start['x']:g}, "
                f"{start['y']:g}), in the task's own at ({x:g}, {y:g}): a program can't know that",
            )
