"""A class with hostile files in it: what the others get is what they get without them."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest
from hostile_files import HOSTILE, hostile_program

from grader.cli import main
from grader.lesson import LESSONS

pytestmark = pytest.mark.skipif(shutil.which("node") is None, reason="the sandbox needs Node")

TASK = LESSONS / "u8-1-a-map-of-cells" / "cell-of-a-point"


def hand_in(folder: Path, learner: str, program: str) -> None:
    (folder / learner).mkdir(parents=True)
    (folder / learner / "cell-of-a-point.py").write_text(program, "utf-8")


def rows_of(out: Path) -> dict[str, dict[str, Any]]:
    rows = map(json.loads, (out / "rows.jsonl").read_text("utf-8").splitlines())
    return {row["learner"]: {**row, "seconds": 0, "key": ""} for row in rows}


def test_honest_marks_are_what_they_are_without_the_hostile(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    mixed, alone, marks = (tmp_path / name for name in ("mixed", "alone", "marks"))
    honest = [TASK / "solution.py", *sorted((TASK / "wrong").glob("*.py"))[:2], TASK / "starter.py"]
    for number, path in enumerate(honest, start=1):
        for folder in (mixed, alone):
            hand_in(folder, f"honest-{number}", path.read_text("utf-8"))
    for what in HOSTILE:
        hand_in(mixed, f"one that {what}", hostile_program(what, mixed, marks))
    files = {path: path.read_bytes() for path in mixed.rglob("*.py")}

    # What nobody hostile was near: plain CPython, the honest files alone.
    assert main(["mark-all", str(alone), "--out", str(tmp_path / "plain"), "--trusted"]) == 0
    capsys.readouterr()
    assert main(["mark-all", str(mixed), "--out", str(marks), "--processes", "2"]) == 0
    said = capsys.readouterr()

    rows = rows_of(marks)
    assert {who: rows[who] for who in rows if who.startswith("honest")} == rows_of(
        tmp_path / "plain"
    )
    assert len(rows) == len(files) == len(honest) + len(HOSTILE)
    for who, row in rows.items():
        if not who.startswith("honest"):
            assert row["status"] == "failed", row
    assert {path: path.read_bytes() for path in mixed.rglob("*.py")} == files
    table = (marks / "marks.csv").read_text("utf-8-sig")
    report = (marks / "report.html").read_text("utf-8")
    assert not set(said.out + said.err + table + report) & set("\x1b\x9b\x07\x08")
