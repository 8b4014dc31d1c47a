"""Programs that a newer Python reads: whatever version runs them, nothing untrue is said."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

import pytest

Run = Callable[..., Any]

NEW = [
    ("d = {'x': 3}\nx = f'{d['x']}'\n", "other kind of quotes"),
    ('d = {"x": 3}\nx = rf"a{d["x"]}b{d["x"]:.1f}"\n', "other kind of quotes"),
    ("try:\n    pass\nexcept ValueError, TypeError:\n    pass\n", "except (A, B)"),
    ("type Cell = tuple[int, int]\n", "Leave out the types"),
    ("def first[T](items: list[T]):\n    return items[0]\n", "Leave out the types"),
    ("x = t'a {3}'\n", "A template"),
]


@pytest.mark.parametrize(("program", "advice"), NEW)
def test_what_only_a_newer_python_reads_is_not_called_wrong(
    run: Run, program: str, advice: str
) -> None:
    ran = run(program)
    if ran.status == "finished":
        assert sys.version_info >= (3, 12)  # here it is read
        return
    hint = ran.fault["hint"]
    assert hint.startswith(f"Python 3.{sys.version_info[1]} runs this, and can't read it; Python")
    assert advice in hint


@pytest.mark.parametrize(
    "program",
    [
        "d = {'x': 3}\nx = f'{d['x']'\n",
        "x = f'{}'\n",
        "except ValueError, TypeError:\n    pass\n",
        "type Cell = \n",
        "def first[T](items\n    pass\n",
        "x = t'a {3'\n",
    ],
)
def test_what_no_python_reads_is_said_to_be_read_by_none(run: Run, program: str) -> None:
    assert "in the page can" not in str(run(program).fault["hint"])
