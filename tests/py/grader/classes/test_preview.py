"""What the preview shows an instructor: each program of a lesson, what it earns, and its mark."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from grader.classes.preview import main
from grader.lesson import CourseError

TINY = Path(__file__).parents[3] / "lessons" / "tiny-course"


def test_every_program_of_a_lesson_is_marked_in_the_order_of_the_page(
    capsys: pytest.CaptureFixture[str],
) -> None:
    main(TINY, "one-step")
    rows = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    first = [row for row in rows if row["task"] == rows[0]["task"]]
    assert [row["file"] for row in first][:2] == ["solution.py", "starter.py"]
    assert [row["mark"]["passed"] for row in first][:2] == [True, False]
    wrong = [row for row in rows if row["earns"] is not None]
    assert len(wrong) == 8
    for row in wrong:
        likely = [check["likely"] for check in row["mark"]["checks"]]
        assert any(row["earns"] in (each or "") for each in likely), row["file"]


def test_a_lesson_that_is_not_there_is_an_instructors_fault() -> None:
    with pytest.raises(CourseError, match="two-steps"):
        main(TINY, "two-steps")
