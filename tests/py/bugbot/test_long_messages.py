"""An error's own text may be of any length; what is looked through for causes is not."""

from __future__ import annotations

import pytest

from bugbot.run import faults
from bugbot.run.slips.case import Case


@pytest.mark.parametrize(
    "error",
    [
        ValueError("x" * 50_000),
        NameError("name '" + "a" * 50_000),
        KeyError("(" * 50_000),
        ExceptionGroup("x" * 50_000, [ValueError("y" * 50_000)]),
        SyntaxError("z" * 50_000),
    ],
)
def test_no_pattern_meets_a_long_text(error: Exception, monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[int] = []

    def look(case: Case) -> None:
        seen.append(len(case.message))

    monkeypatch.setattr(faults, "likely_cause", look)
    fault = faults.fault_of(error, "raise it", "program.py")
    assert seen
    assert max(seen) <= 2000
    assert len(fault.message) <= 2000


def test_no_pattern_meets_a_long_line() -> None:
    line = "x = [" + "[ * + " * 50_000
    case = Case(ValueError(), "", 1, [line], {}, "program.py")
    assert line.startswith(case.text)
    assert len(case.text) <= 2000
