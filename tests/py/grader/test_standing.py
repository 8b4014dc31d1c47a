"""The standing check of a course, and that it fails for each of its reasons."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from grader import cli, standing
from grader.lesson import lesson_at
from grader.standing import check_course

TINY = Path(__file__).parents[2] / "lessons" / "tiny-course"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    shutil.copytree(TINY, tmp_path / "course", ignore=shutil.ignore_patterns("__pycache__"))
    return tmp_path / "course"


@pytest.fixture
def _here(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without processes: each part of the work is done at once, in this one."""

    class Pool:
        def __init__(self, _processes: int) -> None:
            standing._lesson.cache_clear()

        def __enter__(self) -> Pool:
            return self

        def __exit__(self, *_: object) -> None:
            standing._performer().close()

        map = staticmethod(map)

    monkeypatch.setattr(standing, "ProcessPoolExecutor", Pool)


def test_a_sound_course_is_counted_on_the_command_line(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["check", "--lessons", str(folder), "--seeds", "6"]) == 0
    out = capsys.readouterr().out
    row = next(line for line in out.splitlines() if line.startswith("one-step")).split()
    assert row[1:7] == ["2", "5", "2", "12", "48", "8"]
    assert "1 lesson in" in out
    assert "all is well" in out


def put(file: str, text: str) -> Callable[[Path], None]:
    return lambda lesson: write(lesson / file, text)


def write(path: Path, text: str) -> None:
    path.write_text(text)


def replace(file: str, before: str, after: str) -> Callable[[Path], None]:
    def change(lesson: Path) -> None:
        text = (lesson / file).read_text()
        assert before in text
        write(lesson / file, text.replace(before, after))

    return change


SOLUTION = (TINY / "one-step/step-up/solution.py").read_text()


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (put("step-up/starter.py", SOLUTION), "step-up/starter.py: the starter passes; it should"),
        (
            put("step-up/solution.py", "from bugbot import *\n"),
            "step-up/solution.py: the solution fails: Up by 20 cm: expected y at the end is 60",
        ),
        (
            # Noise comes from the text: with this one the first noise does no harm.
            put(
                "step-up/solution.py",
                SOLUTION + "if odometry()[2] % 360 > 180:\n    wait(60)\n# 3\n",
            ),
            "step-up/solution.py: the solution fails with seeds 1000 higher",
        ),
        (
            put("step-up/wrong/down.py", "# earns: it went down\n" + SOLUTION),
            "step-up/wrong/down.py: the wrong attempt passes; it should fail",
        ),
        (
            replace("step-up/wrong/down.py", "it went down", "it fell asleep"),
            "step-up/wrong/down.py:1: should earn 'it fell asleep', but the check 'Up by 20 cm' "
            "names the mistake 'it went down: up the mat y grows'\n",
        ),
        (  # what was expected says "the end" too, but only the mistake is held against it
            replace("step-up/wrong/down.py", "it went down", "the end"),
            "should earn 'the end', but the check 'Up by 20 cm' names the mistake 'it went down",
        ),
        (
            replace("step-up/check.py", '"it went down: up', '"it went away: up'),
            "should earn 'it went down', but the check 'Up by 20 cm' names the mistake 'it went aw",
        ),
        (
            replace("step-up/check.py", "hint=0", "hint=3"),
            "step-up/check.py: the check 'Up by 20 cm' points to hint 3; there are 0 to 2",
        ),
        (
            replace("worlds/other-wall.json", '"x": 100', '"x": 90'),
            "step-up/check.py: in the world other-wall the robot starts at (90, 40), in the task's",
        ),
        (
            replace("step-up/check.py", "task.near(x", "task.nearly(x"),
            "marking it failed: lessons/one-step/step-up/check.py, line 18: AttributeError",
        ),
        (put("stray.txt", ""), "stray.txt: nothing uses this file"),
        (
            lambda lesson: (lesson / "whole-steps/right/loop.py").unlink(),
            "lesson.json:10: the task whole-steps has 3 right solutions in other styles; 4 are w",
        ),
        (
            replace("whole-steps/right/loop.py", "# style:", "#"),
            'right/loop.py:1: line 1 should be "# style: …", how it',
        ),
        (
            replace("whole-steps/right/loop.py", "n += 1", "n += 2"),
            "right/loop.py: the right solution fails: ",
        ),
    ],
)
@pytest.mark.usefixtures("_here")
def test_each_fault_is_found(
    change: Callable[[Path], None], told: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    change(folder / "one-step")
    status = cli.main(["check", "--lessons", str(folder), "--seeds", "2"])
    out = capsys.readouterr().out
    assert status == 1
    assert told in out
    assert "fault" in out.splitlines()[-1]


@pytest.mark.usefixtures("_here")
def test_a_lesson_that_the_course_forgets_is_found(folder: Path) -> None:
    shutil.copytree(folder / "one-step", folder / "two-steps")
    shutil.copytree(folder / "one-step", folder / "_template")  # what lessons are copied from
    first = check_course(folder, seeds=1)[0]
    assert first.slug == "course.json"
    assert [fault.file.parent.name for fault in first.faults] == ["two-steps"]


@pytest.mark.usefixtures("_here")
def test_one_lesson_can_be_checked_alone(folder: Path) -> None:
    write(folder / "course.json", '{"format": 1, "lessons": []}')
    (report,) = check_course(folder, ["one-step"], seeds=1)
    assert (report.faults, report.wrong) == ([], 8)


@pytest.mark.usefixtures("_here")
def test_a_share_of_the_programs_is_always_the_same_one(folder: Path) -> None:
    def marked(one_in: int) -> tuple[int, int, int]:
        (report,) = check_course(folder, ["one-step"], seeds=1, one_in=one_in)
        assert (report.faults, report.starters, report.solutions) == ([], 2, 2)
        return report.right, report.wrong, report.checks

    everything, half = marked(1), marked(2)
    assert half == marked(2)
    assert 0 < half[0] + half[1] < everything[0] + everything[1]


# -- mark ------------------------------------------------------------------------


def test_a_program_is_marked_on_the_command_line(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    task = folder / "one-step/step-up"
    asked = ["mark", "--trusted", "one-step", "step-up", "--lessons", str(folder)]
    assert cli.main([*asked, str(task / "solution.py")]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == "Passed."
    asked[2] = "anywhere/one-step/"  # as shells complete it
    assert cli.main([*asked, str(task / "wrong/ahead.py")]) == 1
    told = capsys.readouterr().out
    assert "likely:   it drove ahead: first turn to heading 0" in told
    assert "help:     hint 2" in told
    assert "where:    world other-wall" in told
    assert cli.main([*asked, str(task / "starter.py"), "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["checks"][0]["status"] == "failed"


def test_a_part_alone_is_marked_in_the_starter(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write(tmp_path / "part.py", "return int(length // step)\n")
    asked = ["mark", "--trusted", "one-step", "whole-steps", str(tmp_path / "part.py")]
    assert cli.main([*asked, "--lessons", str(folder), "--part"]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == "Passed."
    assert cli.main([*asked, "--lessons", str(folder)]) == 1
    write(folder / "one-step/whole-steps/starter.py", "# ---- your part ----\n")
    assert cli.main([*asked, "--lessons", str(folder), "--part"]) == 2
    assert "once and, below it," in capsys.readouterr().err


def test_a_fault_of_ours_is_labelled_so(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write(folder / "one-step/step-up/check.py", "1 / 0\n")
    solution = str(folder / "one-step/step-up/solution.py")
    assert (
        cli.main(["mark", "--trusted", "one-step", "step-up", solution, "--lessons", str(folder)])
        == 2
    )
    assert "This is our fault, not yours: lessons/one-step/step-up" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["mark", "none", "step-up", "x.py"], "there is no lesson in"),
        (["mark", "one-step", "fly", "x.py"], "one-step has no task 'fly'"),
        (["mark", "one-step", "step-up", "none.py"], "can't read none.py"),
        (["check", "none"], "there is no lesson in"),
    ],
)
def test_wrong_usage_is_told(
    arguments: list[str], told: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main([*arguments, "--lessons", str(folder)]) == 2
    assert told in capsys.readouterr().err


def test_a_count_has_bounds(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        cli.main(["check", "--seeds", "0"])
    assert "a whole number from 1 to 1000 is wanted, not 0" in capsys.readouterr().err


def test_the_template_of_a_lesson_is_a_sound_lesson() -> None:
    template = Path(__file__).parents[3] / "lessons" / "_template"
    assert lesson_at(template).faults == []
