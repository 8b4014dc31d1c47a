"""What a class's rows come to: totals per task, the commonest mistakes.

May import: the standard library, `grader.classes.work`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from grader.classes.work import FAILED_ROW, NOT_MARKED, PASSED_ROW, UNREADABLE, Row

__all__ = ["STATUSES", "Mistake", "TaskTotal", "in_order", "totals"]

STATUSES = (PASSED_ROW, FAILED_ROW, UNREADABLE, NOT_MARKED)

MOST_MISTAKES = 5
"""So many of a task's commonest are told."""


@dataclass(frozen=True, slots=True)
class Mistake:
    """What several learners did, and who."""

    words: str
    learners: tuple[str, ...]


@dataclass(slots=True)
class TaskTotal:
    """A task's submissions by their status, and its commonest mistakes."""

    lesson: str
    task: str
    count: Counter[str] = field(default_factory=Counter)
    mistakes: list[Mistake] = field(default_factory=list)


def in_order(rows: Iterable[Row], tasks: Sequence[tuple[str, str]]) -> list[Row]:
    """The rows by learner, and each learner's in the order of the course."""
    place = {task: index for index, task in enumerate(tasks)}
    return sorted(
        rows, key=lambda row: (row["learner"].casefold(), place[row["lesson"], row["task"]])
    )


def totals(rows: Sequence[Row], tasks: Sequence[tuple[str, str]]) -> list[TaskTotal]:
    """Of each task that somebody handed in, in the order of the course."""
    found = []
    for lesson, task in tasks:
        own = [row for row in rows if (row["lesson"], row["task"]) == (lesson, task)]
        if own:
            count = Counter(row["status"] for row in own)
            found.append(TaskTotal(lesson, task, count, _mistakes(own)))
    return found


def _mistakes(rows: Iterable[Row]) -> list[Mistake]:
    """By the first failed check of each, which is the one a learner is shown."""
    learners: dict[str, list[str]] = {}
    for row in rows:
        if row["failed"]:
            first = row["failed"][0]
            words = first["likely"] or f"{first['title']}: {first['got']}"
            learners.setdefault(words, []).append(row["learner"])
    # sorted() keeps the order of those equally common: that of the rows.
    common = sorted(learners.items(), key=lambda item: -len(item[1]))
    return [Mistake(words, tuple(who)) for words, who in common[:MOST_MISTAKES]]
