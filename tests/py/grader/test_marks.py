"""The mark as the page reads it: every field is there, whatever became of the check."""

from __future__ import annotations

from judged import CELL, RIGHT, failed, marked

from grader.marks import first_failed
from grader.report import text_of

PASSED = {
    "title": "On the mat",
    "status": "passed",
    "expected": None,
    "got": None,
    "where": None,
    "likely": None,
    "hint": None,
}


def test_a_passed_check_has_all_fields_of_a_failed_one() -> None:
    mark = marked(CELL, RIGHT)
    assert mark["checks"][0] == PASSED
    assert first_failed(mark) is None
    wrong = marked(CELL, RIGHT.replace("(x / 10)", "(y / 10)"))
    assert set(failed(wrong)) == set(PASSED)
    assert first_failed(wrong) == wrong["checks"][0]


def test_the_first_failed_check_is_the_one_that_failed_not_the_one_that_passed() -> None:
    beside = marked(CELL, "def cell_of(x, y):\n    return int(x / 10), int(y / 10)\n")
    assert [each["status"] for each in beside["checks"]] == ["passed", "failed"]
    assert first_failed(beside) == beside["checks"][1]


def test_the_text_of_a_mark_names_a_world_only_where_one_matters() -> None:
    def where_in(check: str) -> str:
        lines = text_of(marked(check, "def cell_of(x, y):\n    return 9, 9\n")).splitlines()
        return next((each.strip() for each in lines if "where:" in each), "")

    assert where_in(CELL).startswith("where:    cells (")
    assert where_in(CELL.replace("cell_cm=10,", "")) == ""
