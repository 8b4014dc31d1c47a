"""python -m grader mutants: which small changes of the solutions do the checks not notice?

May import: the standard library, `bugbot.errors`, `grader.lesson`, `grader.mutants`.

    python -m grader mutants [LESSON … | LESSON TASK] [--sample N --seed S] [--list] [--json]

Ends with 1 if a change is open: it passes, and no equivalent.json says why it may.
"""

from __future__ import annotations

import argparse
import json
import os
import time
from collections.abc import Callable
from typing import Any

from bugbot.errors import counted
from grader.lesson import CourseError, course, name_of_lesson, shown
from grader.mutants.mutants import Mutant
from grader.mutants.study import Study, sample, studies_of, study_all

__all__ = ["add_arguments", "mutants"]

_COLUMNS = ("mutants", "killed", "explained", "open", "seconds")
_WIDE = 52
"""How wide the first column is."""


def add_arguments(parser: argparse.ArgumentParser, count: Callable[[str], int]) -> None:
    """What can be asked on the command line."""
    parser.add_argument(
        "names",
        nargs="*",
        metavar="NAME",
        type=name_of_lesson,
        help="only these lessons, or a lesson and its task",
    )
    parser.add_argument("--list", action="store_true", help="print the mutants, and try none")
    parser.add_argument("--sample", type=count, metavar="N", help="try only so many, at random")
    parser.add_argument("--seed", type=int, default=1, help="which ones (1)")
    parser.add_argument("--json", action="store_true", help="print a line of JSON for each task")
    parser.add_argument(
        "--processes", type=count, default=os.cpu_count() or 2, help="tried at the same time"
    )


def mutants(options: argparse.Namespace) -> int:
    """Do what the arguments say; returns the exit status."""
    began = time.perf_counter()
    slugs, faults = course(options.lessons)
    if faults:
        raise CourseError(str(faults[0]))
    wanted, task = options.names or slugs, None
    if len(wanted) == 2 and wanted[1] not in slugs:
        wanted, task = wanted[:1], wanted[1]
    studies = studies_of(options.lessons, wanted, task)
    if options.sample is not None:
        sample(studies, options.sample, options.seed)
    if options.list:
        for study in studies:
            for mutant in study.mutants:
                print(_line(study, mutant))
        return 0
    if not options.json:
        print(f"{'task':{_WIDE}}" + "".join(f"{name:>11}" for name in _COLUMNS), flush=True)
    done: list[Study] = []
    for study in study_all(studies, options.processes):
        before = done[-1].lesson.slug if done else study.lesson.slug
        if before != study.lesson.slug and not options.json:
            _tell_lesson(before, done)
        done.append(study)
        if study.mutants or study.faults:
            row = json.dumps(_data(study)) if options.json else _row(study.name, [study])
            print(row, flush=True)
    if not options.json:
        _tell_lesson(done[-1].lesson.slug, done)
        _tell(done, time.perf_counter() - began)
    return 1 if any(study.open or study.faults for study in done) else 0


def _tell_lesson(slug: str, studies: list[Study]) -> None:
    """A lesson's line, below those of its tasks, if it has several."""
    its = [each for each in studies if each.lesson.slug == slug]
    if len(its) > 1:
        print(_row(f"{slug}, {len(its)} tasks", its) + "\n", flush=True)


def _row(name: str, studies: list[Study]) -> str:
    values = (
        sum(len(study.mutants) for study in studies),
        sum(study.killed for study in studies),
        sum(len(study.reasons) for study in studies),
        sum(len(study.open) for study in studies),
        f"{sum(study.seconds for study in studies):.1f}",
    )
    return f"{name:{_WIDE}}" + "".join(f"{value:>11}" for value in values)


def _line(study: Study, mutant: Mutant) -> str:
    number = f"  (number {mutant.number})" if mutant.number > 1 else ""
    where = f"{shown(study.task.solution)}:{mutant.line}"
    inside = f" in {mutant.function}" if mutant.function else ""
    return f"{where}{inside}, {mutant.kind}: {mutant.change}{number}"


def _tell(studies: list[Study], seconds: float) -> None:
    for study in studies:
        if study.open:
            print()
        for mutant in study.open:
            print(_line(study, mutant))
    for study in studies:
        for fault in study.faults:
            print(f"\n{fault}")
    total = sum(len(study.mutants) for study in studies)
    opened = sum(len(study.open) for study in studies)
    faults = sum(len(study.faults) for study in studies)
    killed = sum(study.killed for study in studies)
    explained = sum(len(study.reasons) for study in studies)
    also = f", {counted(faults, 'fault')}" if faults else ""
    print(
        f"\n{counted(total, 'mutant')} in {seconds:.0f} s: {killed} killed, {explained} explained, "
        f"{opened} open{also}"
    )


def _data(study: Study) -> dict[str, Any]:
    def told(mutant: Mutant) -> dict[str, Any]:
        return {
            "kind": mutant.kind,
            "in": mutant.function,
            "line": mutant.line,
            "change": mutant.change,
            "before": mutant.before,
            "after": mutant.after,
            "number": mutant.number,
            "why": study.reasons.get(mutant),
        }

    return {
        "lesson": study.lesson.slug,
        "task": study.task.name,
        "mutants": len(study.mutants),
        "killed": study.killed,
        "explained": [told(each) for each in study.reasons],
        "open": [told(each) for each in study.open],
        "faults": [str(each) for each in study.faults],
        "seconds": round(study.seconds, 1),
    }
