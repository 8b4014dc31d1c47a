"""Holds checks to small changes of the solutions: each must fail, or have its reason.

May import: the standard library, the rest of `grader`.

    <task>/equivalent.json   [{"before": …, "after": …, "reason": why it is no mistake}, …]

`before` and `after` are the statement as `grader.mutants` tells it; "*" stands for any text. An
entry that no living mutant needs is a fault, so that no reason outlives its code.
"""

from __future__ import annotations

import atexit
import json
import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from random import Random

from grader.lesson import CourseError, Fault, Lesson, TaskFolder, course, lesson_at
from grader.marking import Performer, mark_program
from grader.mutants import Mutant, mutants_of
from grader.parts import lines_of_part

__all__ = ["EQUIVALENT", "Tally", "mutate_course"]

EQUIVALENT = "equivalent.json"


@dataclass(slots=True)
class Tally:
    """What became of the mutants of one task."""

    lesson: str
    task: str
    mutants: int = 0
    killed: int = 0
    explained: int = 0
    open: list[Fault] = field(default_factory=list)
    seconds: float = 0.0


def mutate_course(
    folder: Path,
    lesson: str | None = None,
    task: str | None = None,
    *,
    sample: int | None = None,
    processes: int = 2,
) -> list[Tally]:
    """Mark the mutants of every solution, or of a lesson's or a task's; a tally a task.

    sample  so many of all mutants, always the same ones; reasons without a mutant are passed over
    """
    slugs = [lesson] if lesson else course(folder)[0]
    tasks = [
        (each, one)
        for each in (lesson_at(folder / slug) for slug in slugs)
        for one in each.tasks
        if task in (None, one.name)
    ]
    if task is not None and not tasks:
        raise CourseError(f"{lesson} has no task {task!r}")
    work = [
        (number, each.path, one.name, mutant)
        for number, (each, one) in enumerate(tasks)
        for mutant in _mutants(one)
    ]
    if sample is not None and sample < len(work):
        work = sorted(Random(sample).sample(work, sample), key=lambda each: each[0])
    tallies = [Tally(each.slug, one.name) for each, one in tasks]
    lived: list[list[Mutant]] = [[] for _ in tasks]
    with ProcessPoolExecutor(processes) as pool:
        jobs = [(path, name, mutant.program) for _, path, name, mutant in work]
        for (number, _, _, mutant), (passed, seconds) in zip(
            work, pool.map(_passes, jobs, chunksize=4), strict=True
        ):
            tally = tallies[number]
            tally.mutants += 1
            tally.seconds += seconds
            tally.killed += not passed
            if passed:
                lived[number].append(mutant)
    for tally, (_, one), living in zip(tallies, tasks, lived, strict=True):
        _explain(tally, one, living, sample is None)
    return tallies


def _mutants(task: TaskFolder) -> list[Mutant]:
    solution = task.solution.read_text("utf-8")
    return mutants_of(solution, lines_of_part(task.starter.read_text("utf-8"), solution))


def _explain(tally: Tally, task: TaskFolder, living: Sequence[Mutant], complete: bool) -> None:
    path = task.path / EQUIVALENT
    reasons = _reasons(path)
    used: set[int] = set()
    for mutant in living:
        number = next((n for n, each in enumerate(reasons) if _fits(each, mutant)), None)
        if number is None:
            words = f"passes: {mutant.before}  ->  {mutant.after}"
            tally.open.append(Fault(task.solution, mutant.line, words))
        else:
            used.add(number)
            tally.explained += 1
    if complete:
        for number, each in enumerate(reasons):
            if number not in used:
                words = f"no mutant needs this reason any more: {each['before']} -> {each['after']}"
                tally.open.append(Fault(path, None, words))


def _reasons(path: Path) -> list[dict[str, str]]:
    if not path.exists():
        return []
    try:
        reasons = json.loads(path.read_text("utf-8"))
    except ValueError as error:
        raise CourseError(f"{path} is not JSON: {error}") from None
    wanted = {"before", "after", "reason"}
    for each in reasons if isinstance(reasons, list) else [reasons]:
        if not isinstance(each, dict) or each.keys() != wanted or not each["reason"]:
            raise CourseError(f"{path}: each entry wants before, after and reason, all texts")
    return list(reasons)


def _fits(reason: dict[str, str], mutant: Mutant) -> bool:
    pairs = ((reason["before"], mutant.before), (reason["after"], mutant.after))
    return all(wanted in ("*", there) for wanted, there in pairs)


# -- in a process of its own -----------------------------------------------------


@cache
def _performer() -> Performer:
    performer = Performer()
    atexit.register(performer.close)
    return performer


@cache
def _lesson(path: Path) -> Lesson:
    return lesson_at(path)


def _passes(job: tuple[Path, str, str]) -> tuple[bool, float]:
    path, name, program = job
    began = time.perf_counter()
    lesson = _lesson(path)
    check = lesson.task(name).check.read_text("utf-8")
    mark = mark_program(check, lesson.for_judge(), name, program, _performer().perform)
    if mark["ours"] is not None:
        raise CourseError(f"{path.name}/{name}: {mark['ours']}")
    return bool(mark["passed"]), time.perf_counter() - began
