"""mark-all from the command line to its files, on a small class."""

from __future__ import annotations

import csv
import json
import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from distributed import LocalCluster

from grader.classes import command, work
from grader.classes.record import Record
from grader.cli import main
from grader.lesson import LESSONS

FIRST = LESSONS / "u8-1-a-map-of-cells" / "cell-of-a-point"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Six learners: right, wrong in the same way twice, not begun, no text, hostile."""
    top = tmp_path / "class 8b"
    swapped = sorted((FIRST / "wrong").glob("*.py"))[0]
    for learner, source in (
        ("Ada", FIRST / "solution.py"),
        ("Ben", swapped),
        ("Cleo", swapped),
        ("=1+HYPERLINK(2)", FIRST / "starter.py"),
    ):
        (top / learner).mkdir(parents=True)
        shutil.copyfile(source, top / learner / "cell-of-a-point.py")
    (top / "Dan--cell-of-a-point.py").write_bytes(b"def cell_of(x, y):\n    return '\xff'\n")
    (top / "<script>--cell-of-a-point.py").write_text("def cell_of(x, y)\n", "utf-8")
    (top / "Eve.txt").write_text("I have no time", "utf-8")
    return top


def rows_of(out: Path) -> dict[str, dict[str, Any]]:
    lines = (out / "rows.jsonl").read_text("utf-8").splitlines()
    return {row["learner"]: row for row in map(json.loads, lines)}


def without_times(out: Path) -> dict[str, dict[str, Any]]:
    return {who: {**row, "seconds": 0} for who, row in rows_of(out).items()}


def test_a_class_is_marked_and_told(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mark-all", str(folder), "--trusted", "--processes", "2"]) == 0
    out = folder.with_name("class 8b-marks")
    said = capsys.readouterr()
    assert "6 of 6 submissions" in said.out
    assert "1 passed, 4 failed, 1 unreadable" in said.out
    assert "6 of 6 marked" in said.err

    with (out / "marks.csv").open(encoding="utf-8-sig", newline="") as file:
        table = {row["learner"]: row for row in csv.DictReader(file)}
    assert table["Ada"]["status"] == "passed"
    assert table["Ben"]["status"] == "failed"
    assert table["Ben"]["failed check"] != ""
    assert table["Ben"]["likely mistake"] == table["Cleo"]["likely mistake"] != ""
    assert "UTF-8 (byte 0xff on line 2)" in table["Dan"]["note"]
    assert "SyntaxError on line 1" in table["<script>"]["got"]
    assert "'=1+HYPERLINK(2)" in table, "a formula is kept from being one"

    page = (out / "report.html").read_text("utf-8")
    assert "1 passed, 4 failed, 1 unreadable." in page
    assert f"<td>2</td><td><pre>{table['Ben']['likely mistake']}" in page.replace("&#x27;", "'")
    assert "<td>Ben, Cleo</td>" in page
    assert "<td>Eve.txt</td><td>no .py file</td>" in page
    assert "<script" not in page


def test_a_cluster_gives_the_same_marks_as_processes(folder: Path, tmp_path: Path) -> None:
    plain, cluster = tmp_path / "plain", tmp_path / "cluster"
    assert main(["mark-all", str(folder), "--trusted", "--out", str(plain)]) == 0
    with LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0"
    ) as local:
        how = ["--trusted", "--out", str(cluster), "--dask", local.scheduler_address]
        assert main(["mark-all", str(folder), *how]) == 0
    assert without_times(cluster) == without_times(plain)
    assert len(without_times(plain)) == 6


def test_no_scheduler_is_told(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("grader.classes.machines.WAIT_S", 0.2)
    assert main(["mark-all", str(folder), "--trusted", "--dask", "tcp://127.0.0.1:9"]) == 2
    assert "no dask scheduler answers at tcp://127.0.0.1:9" in capsys.readouterr().err


def test_a_marking_that_was_stopped_goes_on(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    marked: list[str] = []

    def one_after_the_other(works: list[work.Work], _processes: int) -> Iterator[work.Row]:
        for each in works:
            if len(marked) == 2:
                raise KeyboardInterrupt
            marked.append(each["learner"])
            yield work.mark_work(each)

    monkeypatch.setattr(command, "by_processes", one_after_the_other)
    out = folder.with_name("class 8b-marks")
    assert main(["mark-all", str(folder), "--trusted"]) == 130
    assert "Stopped. The same command goes on from here." in capsys.readouterr().out
    assert "2 of 6 submissions" in (out / "report.html").read_text("utf-8")
    assert set(rows_of(out)) == set(marked)
    first = list(marked)

    monkeypatch.undo()
    ada = folder / "Ada" / "cell-of-a-point.py"
    ada.write_text(ada.read_text("utf-8") + "# handed in again\n", "utf-8")
    assert main(["mark-all", str(folder), "--trusted"]) == 0
    kept = len(set(first) - {"Ada"})
    assert f"{kept} of 6 are marked already" in capsys.readouterr().err
    assert len(rows_of(out)) == 6


def test_names_and_texts_that_steer_a_screen_are_shown(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    name = os.fsdecode(b"\x1b[2Jzo\xff\xc2\x9b")
    (folder / name).mkdir()
    shutil.copyfile(FIRST / "solution.py", folder / name / "cell-of-a-point.py")
    (folder / f"{name}.txt").write_text("x", "utf-8")
    assert main(["mark-all", str(folder), "--trusted"]) == 0
    said = capsys.readouterr()
    assert "\\x1b[2Jzo\\udcff\\x9b.txt" in said.out
    assert not set(said.out + said.err) & {"\x1b", "\x9b", "\udcff"}
    out = folder.with_name("class 8b-marks")
    assert "\\udcff" in (out / "marks.csv").read_text("utf-8-sig")


def test_a_full_disk_ends_it_clearly_with_the_marks_there_are(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    full = OSError(28, "No space left on device")
    taken: list[str] = []

    def add(_record: Record, row: work.Row) -> None:
        taken.append(row["learner"])
        if len(taken) == 2:
            raise full

    def write(_path: Path, *_: str) -> None:
        raise full

    monkeypatch.setattr(Record, "add", add)
    monkeypatch.setattr(command, "_write", write)
    assert main(["mark-all", str(folder), "--trusted"]) == 2
    said = capsys.readouterr().out
    for name in ("rows.jsonl", "marks.csv", "report.html"):
        assert f"{name} could not be written: No space left on device" in said
    assert all(f"{who}  u8-1-a-map-of-cells  cell-of-a-point" in said for who in taken)


def test_rows_kept_before_outlive_a_stop_at_any_moment(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert main(["mark-all", str(folder), "--trusted"]) == 0
    out = folder.with_name("class 8b-marks")
    before = rows_of(out)
    with (out / "rows.jsonl").open("a", encoding="utf-8") as file:
        file.write('{"learner": "cut sho')

    def killed(*_: object) -> None:
        raise SystemError("killed")

    monkeypatch.setattr(Path, "replace", killed)  # just after a restart, before anything is done
    with pytest.raises(SystemError):
        main(["mark-all", str(folder), "--trusted"])
    assert (out / "rows.jsonl").read_text("utf-8").count("\n") == len(before)
    monkeypatch.undo()
    assert main(["mark-all", str(folder), "--trusted"]) == 0
    assert rows_of(out) == before


def test_another_version_on_a_machine_marks_nothing(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = command.find(folder, [command.lesson_at(FIRST.parent)])
    own = work.work_of(found.submissions[0], trusted=True)
    row = work.mark_work({**own, "sources": "older"})
    assert (row["status"], row["passed"]) == ("not marked", 0)
    assert "another version of the project" in str(row["note"])
