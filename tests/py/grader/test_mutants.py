"""Small changes to a solution: each kind on a line or three, worked by hand."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from grader import cli
from grader.mutants import mutants_of

TINY = Path(__file__).parents[2] / "lessons" / "tiny-course"


def after(body: str) -> list[str]:
    program = f"def f(x, y):\n    {body}\n"
    return [each.after for each in mutants_of(program, range(2, 9))]


@pytest.mark.parametrize(
    ("body", "changes"),
    [
        ("return x < y", ["return x <= y", "return x > y", "return y < y", "return x < x"]),
        ("return x + 1", ["return x - 1", "return x + 2", "return x + 0"]),
        ("return x // y", ["return x / y", "return x % y"]),
        ("return x and y", ["return x or y", "return x", "return y"]),
        ("return not x", ["return x"]),
        ("return -x", ["return x"]),
        ("return int(x)", ["return round(x)", "return x"]),
        ("return math.floor(x)", ["return math.ceil(x)", "return math.trunc(x)", "return x"]),
        ("return max(0, x)", ["return min(0, x)", "return 0", "return x", "return max(1, x)"]),
        ("return math.sin(math.radians(x))", ["return math.cos(math.radians(x))"]),
        ("return math.radians(x)", ["return x", "return math.degrees(x)"]),
        ("return range(x)", ["return range(x + 1)", "return range(x - 1)"]),
        ("return g(x, 3)", ["return g(3, x)"]),
        ("return 0 <= x < 9", ["return 0 <= x", "return x < 9"]),
        ("return [i for i in x if i]", ["return [i for i in x]"]),
        ("if x: return 1\n    return 2", ["without its if", "pass", "after return 2"]),
        ("for i in x: y += i\n    return y", ["left after one round"]),
    ],
)
def test_every_kind_of_change_is_made(body: str, changes: list[str]) -> None:
    assert set(changes) <= set(after(body))


def test_a_constant_is_typed_in_for_its_name_and_given_code_is_left_alone() -> None:
    program = "CELL = 5\ndef f(x):\n    return x * CELL\nprint(f(1) + 1)\n"
    made = mutants_of(program, range(2, 4))
    assert "return x * 5" in [each.after for each in made]
    assert all(each.line in (2, 3) for each in made)
    assert all(each.program.endswith("print(f(1) + 1)") for each in made)


def test_each_change_is_made_alone_and_only_once() -> None:
    made = mutants_of('def f(x):\n    "Doc."\n    return x + 1 + 1\n', range(1, 4))
    programs = [each.program for each in made]
    assert len(programs) == len(set(programs))
    assert all("Doc." in each for each in programs)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    shutil.copytree(TINY, tmp_path / "course", ignore=shutil.ignore_patterns("__pycache__"))
    return tmp_path / "course"


def run(folder: Path, *more: str) -> int:
    return cli.main(["mutants", "one-step", "whole-steps", "--lessons", str(folder), *more])


def test_what_passes_is_open_until_there_is_a_reason(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    task = folder / "one-step" / "whole-steps"
    check = (task / "check.py").read_text()
    # A check that tries one length lets more pass than one that tries many.
    weak = check.partition("@check")[0] + (
        '@check("One")\ndef one(task):\n    task.call(steps, 10, 5, gives=2)\n'
    )
    (task / "check.py").write_text(weak)
    assert run(folder) == 1
    out = capsys.readouterr().out
    assert "solution.py:" in out
    assert "passes: " in out

    every = [{"before": "*", "after": "*", "reason": "for this test"}]
    (task / "equivalent.json").write_text(json.dumps(every))
    assert run(folder) == 0
    assert "none open" in capsys.readouterr().out


def test_a_reason_that_nothing_needs_is_a_fault(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    reason = {"before": "return 7", "after": "return 8", "reason": "once upon a time"}
    path = folder / "one-step" / "whole-steps" / "equivalent.json"
    path.write_text(json.dumps([reason]))
    assert run(folder) == 1
    assert "no mutant needs this reason any more: return 7" in capsys.readouterr().out
    path.write_text("[1]")
    assert run(folder) == 2
