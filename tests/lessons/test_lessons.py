"""Every lesson's folder is sound, and the template's starter fails and its solution passes.

This is the quick part of the standing check. All of it, of every lesson, is `npm run lesson:check`,
which `npm test` runs too.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from grader.lesson import LESSONS, Lesson, TaskFolder, course, lesson_at
from grader.marking import Performer, mark_program
from grader.report import text_of

SLUGS = ["_template", *(path.parent.name for path in sorted(LESSONS.glob("u*/lesson.json")))]
TEMPLATE = lesson_at(LESSONS / "_template")
TASKS = [(TEMPLATE, task) for task in TEMPLATE.tasks]


@pytest.fixture(scope="module")
def performer() -> Iterator[Performer]:
    with Performer() as performer:
        yield performer


def test_the_course_names_lessons_that_are_there() -> None:
    assert course(LESSONS)[1] == []


@pytest.mark.parametrize("slug", SLUGS)
def test_the_folder_of_a_lesson_is_sound(slug: str) -> None:
    assert [str(fault) for fault in lesson_at(LESSONS / slug).faults] == []


@pytest.mark.parametrize(
    ("lesson", "task"), TASKS, ids=[f"{lesson.slug}/{task.name}" for lesson, task in TASKS]
)
def test_a_starter_fails_and_the_solution_passes(
    lesson: Lesson, task: TaskFolder, performer: Performer
) -> None:
    def marked(program: Path) -> tuple[bool, str]:
        check, source = task.check.read_text("utf-8"), program.read_text("utf-8")
        mark = mark_program(check, lesson.for_judge(), task.name, source, performer.perform)
        assert mark["ours"] is None, mark["ours"]
        return mark["passed"], text_of(mark)

    passed, told = marked(task.solution)
    assert passed, told
    passed, told = marked(task.starter)
    assert not passed, told
