"""What the authors' page is told: marks of programs, causes, and the run of a failed check."""

from __future__ import annotations

import json
from pathlib import Path
from shutil import copytree
from typing import Any

import pytest

from grader.classes.preview import main
from grader.lesson import CourseError

TINY = Path(__file__).parents[3] / "lessons" / "tiny-course"


def told(
    capsys: pytest.CaptureFixture[str], task: str, *files: str, lessons: Path = TINY
) -> dict[str, Any]:
    main(lessons, "one-step", task, files)
    rows = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    return {row["file"]: row for row in rows}


def test_each_program_has_its_mark(capsys: pytest.CaptureFixture[str]) -> None:
    files = ("solution.py", "starter.py", "wrong/one-too-many.py")
    rows = told(capsys, "whole-steps", *files)
    assert {file: row["mark"]["passed"] for file, row in rows.items()} == {
        "solution.py": True,
        "starter.py": False,
        "wrong/one-too-many.py": False,
    }
    first = rows["wrong/one-too-many.py"]["mark"]["checks"][0]
    assert first["likely"].startswith("one step too many")


def test_the_causes_are_told_with_hint_and_line(capsys: pytest.CaptureFixture[str]) -> None:
    causes = told(capsys, "step-up", "solution.py")["solution.py"]["causes"]
    assert causes[:2] == [
        {"text": "it went down: up the mat y grows", "hint": None, "line": 6},
        {"text": "it drove ahead: first turn to heading 0", "hint": 1, "line": 7},
    ]
    assert len(causes) == 4


def test_a_cause_that_an_expectation_names_is_one_of_them(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    copytree(TINY, tmp_path / "course")
    check = tmp_path / "course/one-step/step-up/check.py"
    check.write_text(
        check.read_text("utf-8")
        + '    task.expect(True, expected="a", got="b", likely="it stood", hint=2)\n'
    )
    rows = told(capsys, "step-up", "solution.py", lessons=tmp_path / "course")
    causes = rows["solution.py"]["causes"]
    assert causes[-1] == {"text": "it stood", "hint": 2, "line": 19}


def test_the_run_of_a_failed_check_comes_along(capsys: pytest.CaptureFixture[str]) -> None:
    rows = told(capsys, "step-up", "wrong/down.py", "solution.py")
    assert rows["wrong/down.py"]["run"]["place"]["world"]["name"] == "other-wall"
    assert rows["wrong/down.py"]["run"]["trace"]["events"]
    assert rows["solution.py"]["run"] is None


def test_a_file_that_cant_be_read_has_its_trouble(capsys: pytest.CaptureFixture[str]) -> None:
    rows = told(capsys, "step-up", "wrong/gone.py")
    assert "gone.py" in rows["wrong/gone.py"]["trouble"]


def test_a_lesson_or_task_that_is_not_there_is_an_instructors_fault() -> None:
    with pytest.raises(CourseError, match="two-steps"):
        main(TINY, "two-steps", "step-up", ())
    with pytest.raises(CourseError, match="step-down"):
        main(TINY, "one-step", "step-down", ())
