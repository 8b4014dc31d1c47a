"""What learners will be told: every program of a lesson's tasks, marked, for the preview page.

May import: the standard library, `grader`.

    python -m grader.classes.preview LESSONS SLUG

Prints a line of JSON for each program as soon as it is marked, in the order of the page:
{"task", "file", "earns": null | text, "mark"}. `npm run dev` shows them (site/build/preview.mjs).
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from grader.lesson import CourseError, TaskFolder, lesson_at
from grader.marking import Performer, mark_program

__all__ = ["main"]


def main(lessons: Path, slug: str) -> None:
    """Mark and print."""
    lesson = lesson_at(lessons / slug)
    with Performer() as performer:
        for task in lesson.tasks:
            check = task.check.read_text("utf-8")
            for path, earns in _programs(task):
                program = path.read_text("utf-8")
                mark = mark_program(
                    check, lesson.for_judge(), task.name, program, performer.perform
                )
                file = path.relative_to(task.path).as_posix()
                told = {"task": task.name, "file": file, "earns": earns, "mark": mark}
                print(json.dumps(told), flush=True)


def _programs(task: TaskFolder) -> list[tuple[Path, str | None]]:
    wrong: list[tuple[Path, str | None]] = [(each.path, each.earns) for each in task.wrong]
    return [(task.solution, None), (task.starter, None), *wrong]


if __name__ == "__main__":
    try:
        main(Path(sys.argv[1]), sys.argv[2])
    except CourseError as error:
        sys.exit(f"grader: {error}")
