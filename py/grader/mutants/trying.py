"""Marks a mutant as far as is needed to see it fail.

May import: the standard library, `grader.judge`, `grader.lesson`, `grader.marking`,
`grader.mutants`.

The jobs of a marking are done one after the other, the quickest first, and after each the checks
are gone through with the results there are: one that fails already is enough. A job
may take a few times as long as the solution's; a mutant that takes longer hangs, and that is
failing too.
"""

from __future__ import annotations

import time
from itertools import count
from typing import Any

from grader.judge import fails_already, step
from grader.lesson import Lesson, TaskFolder
from grader.marking import Performer

__all__ = ["BrokenCheckError", "Trying", "Usual", "for_task"]

_PATIENCE = 10
"""A job may take so many times the solution's seconds."""

_PATIENCE_S = 5.0
"""And so many seconds more: starting an interpreter on a busy machine takes some."""


Usual = dict[str, float]
"""How long each job of a task's solution took [s], by its round and its place in it."""


class BrokenCheckError(Exception):
    """A check.py that can't judge a program; the message is what marking says of it."""


def for_task(lesson: Lesson, task: TaskFolder) -> dict[str, Any]:
    """What a judge of this task knows of its lesson: of the starters, its own alone."""
    known = lesson.for_judge()
    return {**known, "starters": {task.name: known["starters"].get(task.name, "")}}


class Trying:
    """Marks programs of one task."""

    def __init__(self, lesson: Lesson, task: TaskFolder, performer: Performer) -> None:
        self._lesson = for_task(lesson, task)
        self._task = task.name
        self._check = task.check.read_text("utf-8")
        self._performer = performer

    def mark_solution(self, program: str) -> tuple[dict[str, Any], Usual]:
        """The mark of the solution, and how long its jobs took."""
        results: list[dict[str, Any]] = []
        usual: Usual = {}
        kept: dict[str, Any] = {}
        for number in count():
            done = step(self._check, self._lesson, self._task, program, results, kept=kept)
            if "mark" in done:
                return done["mark"], usual
            for place, job in enumerate(done["jobs"]):
                began = time.perf_counter()
                results.append(self._performer.perform(job, program))
                usual[f"{number}-{place}"] = time.perf_counter() - began
        raise AssertionError("step ends every marking")

    def passes(self, program: str, usual: Usual) -> bool:
        """Does a changed program pass? Raises BrokenCheckError if the check.py breaks on it.

        usual  without it, every job has its full time, and they are done as they come
        """
        results: list[dict[str, Any]] = []
        kept: dict[str, Any] = {}
        for number in count():
            done = step(self._check, self._lesson, self._task, program, results, kept=kept)
            if "mark" in done:
                if done["mark"]["ours"] is not None:
                    raise BrokenCheckError(done["mark"]["ours"])
                return bool(done["mark"]["passed"])
            jobs = [(usual.get(f"{number}-{at}"), job) for at, job in enumerate(done["jobs"])]
            for seconds, job in sorted(jobs, key=lambda each: each[0] or 0.0):
                results.append(self._performer.perform(_limited(job, seconds), program))
                if len(jobs) > 1 and fails_already(
                    self._check, self._lesson, self._task, program, results, kept=kept
                ):
                    return False
        raise AssertionError("step ends every marking")


def _limited(job: dict[str, Any], usual_s: float | None) -> dict[str, Any]:
    if usual_s is None:
        return job
    real_s = min(job["limits"]["real_s"], _PATIENCE_S + _PATIENCE * usual_s)
    return {**job, "limits": {**job["limits"], "real_s": real_s}}
