"""A lesson's folder and its JSON: every fault is told with its file and line."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from grader.lesson import CourseError, course, lesson_at
from grader.schema import read

TINY = Path(__file__).parents[2] / "lessons" / "tiny-course"


@pytest.fixture
def lesson(tmp_path: Path) -> Path:
    shutil.copytree(TINY, tmp_path / "course", ignore=shutil.ignore_patterns("__pycache__"))
    return tmp_path / "course" / "one-step"


def faults(lesson: Path) -> list[str]:
    root = f"{lesson.as_posix()}/"
    return [str(fault).replace(root, "") for fault in lesson_at(lesson).faults]


def test_the_tiny_lesson_is_sound(lesson: Path) -> None:
    read_lesson = lesson_at(lesson)
    assert read_lesson.faults == []
    assert [task.name for task in read_lesson.tasks] == ["whole-steps", "step-up"]
    assert [len(task.wrong) for task in read_lesson.tasks] == [4, 4]
    assert list(read_lesson.worlds) == ["other-wall"]


def replace(file: str, before: str, after: str) -> Callable[[Path], None]:
    def change(lesson: Path) -> None:
        text = (lesson / file).read_text()
        assert before in text
        (lesson / file).write_text(text.replace(before, after, 1))

    return change


def write(file: str, text: str) -> Callable[[Path], None]:
    return lambda lesson: void((lesson / file).write_text(text))


def remove(file: str) -> Callable[[Path], None]:
    return lambda lesson: (lesson / file).unlink()


def void(_: object) -> None:
    return None


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (replace("lesson.json", '"format": 1,', '"format": 1'), r"lesson.json:3: this is not JSON"),
        (replace("lesson.json", '"format": 1', '"format": 2'), r"lesson.json:2: format is 2; it"),
        (
            replace("lesson.json", '"One step"', "7"),
            r"lesson.json:3: title should be a text; it is 7",
        ),
        (replace("lesson.json", '"One step"', '" "'), r"lesson.json:3: title is empty"),
        (replace("lesson.json", '"goals"', '"gaols"'), r"lesson.json:1: the file lacks 'goals'"),
        (replace("lesson.json", '"goals"', '"gaols"'), r"lesson.json:5: gaols is not known here"),
        (replace("lesson.json", '["take a step"]', "[]"), r"lesson.json:5: goals should have at"),
        (
            replace("lesson.json", '"assumes": []', '"assumes": ["a", "a"]'),
            r"lesson.json:6: assumes says the same",
        ),
        (
            replace("lesson.json", '"assumes": []', '"minutes": 1'),
            r"lesson.json:6: minutes is 1; it should be 5",
        ),
        (
            replace("lesson.json", '"assumes": []', '"minutes": true'),
            r"lesson.json:6: minutes should be an integ",
        ),
        (
            replace("lesson.json", '"Look.", ', ""),
            r"lesson.json:14: tasks\[0\].hints should have 3",
        ),
        (
            replace("lesson.json", '"whole-steps"', '"Whole Steps"'),
            r"lesson.json:10: tasks\[0\].na",
        ),
        (replace("lesson.json", '"wall-ahead" }', '"mars" }'), r"lesson.json:7: there is no world"),
        (remove("programs/look-ahead.py"), r"lesson.json:7: .*look-ahead.py is missing"),
        (remove("step-up/starter.py"), r"lesson.json:\d+: .*step-up/starter.py is missing"),
        (
            remove("step-up/wrong/down.py"),
            r"lesson.json:\d+: the task step-up has 3 wrong attempts",
        ),
        (
            replace("step-up/wrong/down.py", "# earns: ", "# "),
            r"step-up/wrong/down.py:1: line 1 sh",
        ),
        (
            replace("step-up/wrong/down.py", "it went down", ""),
            r"step-up/wrong/down.py:1: line 1 s",
        ),
        (remove("lesson.md"), r"lesson.md: the file is missing"),
        (
            replace("lesson.md", "::task step-up", ""),
            r"lesson.json:\d+: the task step-up stands 0 t",
        ),
        (
            replace("lesson.md", "Steps.", "::program look-ahead"),
            r"lesson.json:7: the program look-ahead stands 2 times",
        ),
        (write("notes.txt", "x"), r"notes.txt: nothing uses this file"),
        (write("step-up/old.py", "x"), r"step-up/old.py: nothing uses this file"),
        (
            replace("step-up/check.py", '"other-wall"', '"empty"'),
            r"worlds/other-wall.json: nothing uses this file",
        ),
        (
            replace("worlds/other-wall.json", '"other-wall"', '"wall"'),
            r"worlds/other-wall.json:1: its name",
        ),
        (
            replace("worlds/other-wall.json", '"start"', '"stop"'),
            r"worlds/other-wall.json:1: the world: st",
        ),
        (
            replace("worlds/other-wall.json", "{", ""),
            r"worlds/other-wall.json:\d: this is not JSON",
        ),
    ],
)
def test_what_is_wrong_is_told_with_file_and_line(
    change: Callable[[Path], None], told: str, lesson: Path
) -> None:
    change(lesson)
    found = faults(lesson)
    assert any(re.match(told, fault) for fault in found), found


def test_a_folder_without_a_lesson_is_refused(tmp_path: Path) -> None:
    with pytest.raises(CourseError, match=r"it has no lesson\.json"):
        lesson_at(tmp_path)


def test_a_task_that_is_not_there_is_refused(lesson: Path) -> None:
    with pytest.raises(CourseError, match="has no task 'fly'; its tasks: whole-steps, step-up"):
        lesson_at(lesson).task("fly")


def test_a_file_that_is_no_text_is_refused(lesson: Path) -> None:
    (lesson / "lesson.json").write_bytes(b"\xff")
    with pytest.raises(CourseError, match=r"lesson\.json can't be read"):
        lesson_at(lesson)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("[]", "the file should be an object"),
        ('{"format": 1, "lessons": ["one-step", "two"]}', "there is no lesson two"),
        ('{"format": 1, "lessons": ["one-step", "one-step"]}', "lessons says the same twice"),
        ('{"format": 1}', "the file lacks 'lessons'"),
    ],
)
def test_faults_of_the_course(text: str, told: str, lesson: Path) -> None:
    (lesson.parent / "course.json").write_text(text)
    assert any(told in str(fault) for fault in course(lesson.parent)[1])


def test_a_schema_that_says_more_than_is_known_is_refused() -> None:
    with pytest.raises(ValueError, match="the schema uses oneOf, which is not known here"):
        read("{}", {"oneOf": []})


def test_lines_are_those_of_the_values() -> None:
    text = json.dumps({"a": {"b": [1, {"c\\": "]"}, 3]}, "d": True}, indent=1)
    document = read(text, {})
    assert document.line_of("a", "b", 1, "c\\") == 6
    assert document.line_of("a", "b", 2) == 8
    assert document.line_of("a", "b", 9) == 3
    assert document.line_of("d") == 11
