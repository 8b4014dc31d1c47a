"""Runs that are all reported: figures held against limits, points, why each stopped."""

from __future__ import annotations

from typing import Any

import pytest
from judged import failed, marked, statuses

from grader.report import text_of

CHECK = """
from grader import check, scoring

POINTS = scoring("A point for each bump.", lambda run, drawn: run.bumps, of=1)

def judge(task, world):
    for trial in task.trials(world, seeds=(1, 2), seconds=9, scored=POINTS, mistakes=[
        ("it drives the wrong way", lambda run: run.pose_at(9)[1] < 40, 1),
    ]):
        trial.known(at_most=0.1).took(at_most=5).drove(at_most=25).bumps()
        trial.figure("x", lambda run, drawn: run.pose_at(9)[0], "cm", at_least=90, digits=0)
        trial.says_why(after="stops:")

@check("A wall", hint=0)
def wall(task):
    judge(task, "wall-ahead")

@check("A slab")
def slab(task):
    judge(task, "slab-ahead")
"""
"""Both worlds have the robot at (100, 40), facing up."""

WALL = {
    "name": "slab-ahead",
    "title": "Slab ahead",
    "description": "A slab across the mat.",
    "start": {"x": 100, "y": 40, "heading": 0},
    "obstacles": [{"x": 50, "y": 60, "width": 100, "height": 20, "name": "slab"}],
}


def drawing(free: str = "[(102.5, 52.5)]", occupied: str = "[]") -> str:
    """A program that draws these cells of 5 cm; `hit` is that in which a beam ended."""
    return (
        "from bugbot import *\nimport math\n(angle, reading) = scan()[3]\n"
        "way = math.radians(angle)\n"
        "end = (100 + reading * math.sin(way), 40 + reading * math.cos(way))\n"
        "hit = [5 * (at // 5) + 2.5 for at in end]\n"
        f'draw("free", {free}, "blue", "squares", 5)\n'
        f'draw("occupied", {occupied}, "black", "squares", 5)\n'
    )


MAP = drawing()


def mark_of(program: str, check: str = CHECK) -> dict[str, Any]:
    return marked(check, program, worlds={"slab-ahead": WALL})


def figures(result: dict[str, Any]) -> dict[str, tuple[Any, Any]]:
    return {each["name"]: (each["value"], each["met"]) for each in result["figures"]}


def test_each_run_is_reported_with_its_figures_and_the_score_is_their_mean() -> None:
    mark = mark_of(f"{MAP}forward(100, 20)\nprint('stops: nothing left')\n")
    assert mark["passed"], text_of(mark)
    results = mark["results"]
    named = [(each["check"], each["world"]["title"], each["seed"]) for each in results]
    assert named == [
        (0, "A wall ahead", 1),
        (0, "A wall ahead", 2),
        (1, "Slab ahead", 1),
        (1, "Slab ahead", 2),
    ]
    by_wall, by_slab = figures(results[0]), figures(results[2])
    assert by_wall["known"] == (0.062, True)  # one of 1,600 cells
    assert by_wall["bumps"] == (0, None)
    assert by_wall["distance"] == (pytest.approx(20, abs=3), True)
    assert by_slab["bumps"] == (1, None)
    assert {each["why"] for each in results} == {"nothing left"}
    assert {each["ended"] for each in results} == {"finished"}
    assert all(each["passed"] for each in results)
    assert [each["points"] for each in results] == [0, 0, 1, 1]
    assert mark["score"] == {"value": 0.5, "of": 1, "how": "A point for each bump."}


def test_each_result_has_its_map_with_what_is_wrong_in_it_and_its_path() -> None:
    drawn = MAP.replace("[(102.5, 52.5)]", "[(102.5, 52.5), (102.5, 62.5)]")
    drawn = drawn.replace('"occupied", []', '"occupied", [(97.5, 57.5), (97.5, 47.5)]')
    result = mark_of(f"{drawn}forward(100, 10)\n")["results"][2]
    found = result["map"]
    assert (found["across"], found["cell_cm"], len(found["cells"])) == (40, 5, 1600)
    rows = [found["cells"][start : start + 40] for start in range(0, 1600, 40)]
    assert rows[9] == f"{'?' * 19}!{'?' * 20}"  # (97.5, 47.5), the slab begins at 60
    assert rows[10] == f"{'?' * 20}.{'?' * 19}"
    assert rows[11] == f"{'?' * 19}#{'?' * 20}"
    assert rows[12] == f"{'?' * 20}x{'?' * 19}"
    assert result["path"][0] == [100, 40]
    assert result["path"][-1] == [100, pytest.approx(50, abs=1)]


def test_all_figures_are_taken_though_one_is_outside_its_limit() -> None:
    mark = mark_of(f"{MAP}forward(100, 30)\n")
    check = failed(mark)
    assert statuses(mark) == ["failed", "failed"]
    assert check["expected"] == "a path of at most 25 cm"
    assert check["got"].endswith("cm (seed 1)")
    assert check["where"]["job"] == mark["results"][0]["job"]
    found = figures(mark["results"][0])
    assert found["distance"][1] is False
    assert found["x"] == (pytest.approx(100, abs=3), True)
    assert mark["results"][0]["why"] == "its last line was reached"
    assert not any(each["passed"] for each in mark["results"])


@pytest.mark.parametrize(
    ("program", "expected", "likely"),
    [
        (f"{MAP}print('stops: x')\ndrive(0, 100, 0)\nwait(1)\nprint('stops:  ')", None, None),
        (f"{MAP}print('stop: nothing left')", "a printed line that says why it stops", None),
        (f"{MAP}print('stops: x')\ndrive(0, -100, 0)\nwait(2)", "x: at least 90 cm", None),
        (
            f"{MAP}print('stops: x')\nbackward(100, 26)",
            "a path of at most 25 cm",
            "it drives the wrong way",
        ),
    ],
)
def test_what_is_not_met_is_the_checks_failure_with_the_slip(
    program: str, expected: str | None, likely: str | None
) -> None:
    mark = mark_of(program)
    if expected is None:
        assert mark["passed"], text_of(mark)
        return
    assert failed(mark)["expected"].startswith(expected)
    assert failed(mark)["likely"] == likely


FIGURES = """
from grader import check

@check("It")
def it(task):
    for trial in task.trials("wall-ahead", seeds=(1, 2), seconds=9):
        trial.known(at_least=0.05, at_most=50).wrong_walls(at_most=10).wrong_floor(at_most=20)
        trial.took(at_most=3).drove().bumps(at_most=0)
        trial.figure("cells", lambda run, drawn: drawn.score.free, at_least=1, at_most=1)
        trial.figure("x", lambda run, drawn: run.pose_at(9)[0], "cm")
        trial.says_why(after="stops:")
"""


def drawn(free: str = "[(102.5, 52.5)]", occupied: str = "[hit]") -> str:
    """The same, and it says why it stops."""
    return f"{drawing(free, occupied)}print('stops: x')\n"


def of_one_run(program: str, check: str = FIGURES) -> dict[str, Any]:
    return {each["name"]: each for each in marked(check, program)["results"][0]["figures"]}


def test_a_figure_has_its_limits_its_unit_and_its_digits() -> None:
    found = of_one_run(drawn())
    shape = {
        name: (each["unit"], each["at_least"], each["at_most"], each["digits"], each["met"])
        for name, each in found.items()
    }
    assert shape == {
        "known": ("%", 0.05, 50, 1, True),
        "wrong walls": ("%", None, 10, 1, True),
        "wrong floor": ("%", None, 20, 1, True),
        "time": ("s", None, 3, 1, True),
        "distance": ("cm", None, None, 0, None),
        "bumps": ("", None, 0, 0, True),
        "cells": ("", 1, 1, 1, True),
        "x": ("cm", None, None, 1, None),
    }
    values = {name: each["value"] for name, each in found.items()}
    assert (values["known"], values["wrong walls"], values["wrong floor"]) == (0.125, 0, 0)
    assert (values["cells"], values["x"]) == (1, pytest.approx(100, abs=1))


def test_without_a_map_its_figures_are_there_with_their_limits() -> None:
    found = of_one_run("from bugbot import *\nprint('stops: x')\n")
    for name, limits in {
        "known": ("%", 0.05, 50),
        "wrong walls": ("%", None, 10),
        "wrong floor": ("%", None, 20),
    }.items():
        each = found[name]
        assert (each["unit"], each["at_least"], each["at_most"]) == limits
        assert (each["value"], each["digits"], each["met"]) == (None, 1, False)


@pytest.mark.parametrize(
    ("program", "expected", "got"),
    [
        (drawn(free="[]", occupied="[]"), "at least 0.05 % of the mat known", "0.0 % (seed 1)"),
        (
            drawn(occupied="[(102.5, 57.5)]"),
            "at most 10 % of the occupied cells more than a cell from anything real",
            "100.0 %: 1 of 1 cell (seed 1)",
        ),
        (
            drawn(free="[(102.5, 52.5), (102.5, 152.5)]"),
            "at most 20 % of the free cells inside something solid",
            "50.0 %: 1 of 2 cells (seed 1)",
        ),
        (f"{drawn()}wait(4)", "a run of at most 3 s", "4.0 s (seed 1)"),
        (
            drawn(free="[(102.5, 52.5), (102.5, 57.5)]"),
            "cells: at least 1 and at most 1",
            "2.0 (seed 1)",
        ),
        (
            drawn().replace("stops:", "it stops"),
            "a printed line that says why it stops, after 'stops:'",
            "the last line printed is 'it stops x' (seed 1)",
        ),
    ],
)
def test_what_is_outside_its_limit_is_told(program: str, expected: str, got: str) -> None:
    check = failed(marked(FIGURES, program))
    assert (check["expected"], check["got"]) == (expected, got)


def test_walls_found_and_what_has_no_support_are_figures_too() -> None:
    check = FIGURES.replace(".took(", ".walls_found(at_least=100).unsupported(at_most=10).took(")
    looks = drawn().replace(
        "(angle, reading) = scan()[3]",
        "looks = [scan() for _ in range(3)]\n(angle, reading) = looks[0][3]",
    )
    found = of_one_run(looks, check)
    # Eight places of the wall were met three times; one cell is black, and those beside it count.
    assert found["walls found"]["value"] == pytest.approx(100 * 2 / 8, abs=13)
    assert found["walls found"]["met"] is False
    assert (found["unsupported"]["value"], found["unsupported"]["met"]) == (0, True)
    painted = looks.replace("[hit]", "[hit, (2.5, 2.5)]")
    assert of_one_run(painted, check)["unsupported"]["value"] == 0.062
    first = failed(marked(check, painted))
    assert first["expected"].startswith("at least 100 % of the walls that its beams have met")


def test_bumps_have_a_limit() -> None:
    backwards = f"{drawn()}backward(100, 60)\n"
    patient = FIGURES.replace("at_most=3", "at_most=9")
    assert failed(marked(patient, backwards))["expected"].startswith("the robot to touch")
    bumps = of_one_run(backwards, patient)["bumps"]
    assert (bumps["value"], bumps["met"]) == (1, False)


@pytest.mark.parametrize(
    ("said", "why"),
    [
        ("stops: a: b", "a: b"),
        ("stops: it stops: twice", "it stops: twice"),
        ("stops: no way: ", "no way"),
        ("stops: XX", "XX"),
    ],
)
def test_why_it_stops_is_what_is_printed_after_the_words(said: str, why: str) -> None:
    mark = marked(FIGURES, f"{drawn()}print({said!r})\n")
    assert [each["why"] for each in mark["results"]] == [why, why]


def test_a_reason_has_to_hold_if_the_check_asks_whether_it_does() -> None:
    asks = FIGURES.replace(
        'says_why(after="stops:")',
        """says_why(after="stops:", holds=lambda said, run, drawn:
            None if said == "x" else Untrue("x", f"{said} at {run.seconds:g} s", (60,)))""",
    ).replace(
        "from grader import check", "from grader import check\nfrom mapping.reasons import Untrue"
    )
    assert marked(asks, drawn())["passed"]
    first = failed(marked(asks, drawn().replace("stops: x", "stops: lunch")))
    assert first["expected"] == "a reason that is true: x"
    assert first["got"] == '"lunch", but lunch at 0 s (seed 1)'
    assert first["where"]["cells"] == [[20, 1]]
    # Without a map, and of a run that broke off, there is nothing to hold it against.
    crashed = marked(asks, drawn().replace("stops: x", "stops: lunch") + "1 / 0")
    assert "ZeroDivisionError" in failed(crashed)["got"]


def test_a_figure_that_can_not_be_had_fails_its_trial() -> None:
    asks = FIGURES.replace("run.pose_at(9)[0]", 'run.line("known %").end')
    mark = marked(asks, drawn())
    assert failed(mark)["expected"].startswith('a line named "known %"')
    assert of_one_run(drawn(), asks)["x"]["value"] is None


def test_a_trial_alone_needs_no_seed_in_its_failure() -> None:
    alone = FIGURES.replace("seeds=(1, 2)", "seeds=(1,)")
    assert failed(marked(alone, f"{drawn()}wait(4)"))["got"] == "4.0 s"


def test_a_run_cut_short_keeps_its_figures_and_is_worth_nothing() -> None:
    mark = mark_of(f"{MAP}while True:\n    wait(1)\n")
    result = mark["results"][0]
    assert (result["ended"], result["points"], result["passed"]) == ("limit", 0, False)
    assert "9 simulated seconds" in result["why"]
    assert figures(result)["known"] == (0.062, True)
    assert figures(result)["time"] == (9, False)
    assert mark["score"]["value"] == 0
    # The same trouble of the whole program is told once.
    assert statuses(mark) == ["failed", "not run"]


def test_a_run_without_a_map_or_a_record_has_no_figures_of_it() -> None:
    mark = mark_of("from bugbot import *\nprint('stops: x')\n")
    assert failed(mark)["expected"].startswith('a layer named "free"')
    assert figures(mark["results"][0])["known"] == (None, False)
    assert figures(mark["results"][0])["time"] == (0, True)
    assert figures(mark["results"][0])["x"] == (None, False)
    assert mark["results"][0]["map"] is None


def test_a_map_of_cells_that_no_beam_has_seen_is_worth_nothing() -> None:
    behind = [(2.5, 2.5 + 5 * row) for row in range(30)]
    drawn = MAP.replace("[(102.5, 52.5)]", repr(behind))
    check = CHECK.replace("run.bumps", "1").replace("at_most=0.1", "at_most=50")
    mark = mark_of(f"{drawn}print('stops: x')\n", check)
    assert failed(mark)["expected"].startswith("a map of what the beams")
    assert [each["points"] for each in mark["results"]] == [0, 0, 0, 0]


def test_a_figure_is_never_shown_as_the_limit_that_it_misses() -> None:
    check = CHECK.replace("at_most=0.1", "at_least=0.1")
    known = mark_of(f"{MAP}print('stops: x')\n", check)["results"][0]["figures"][0]
    assert (known["value"], known["digits"], known["met"]) == (0.062, 2, False)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("seeds=(1, 2)", "seeds=(1, 1)", "task.trials(…) wants different seeds; it got [1, 1]"),
        ("of=1", "of=0", "scoring(how, points, of=…) wants a function"),
        ("scored=POINTS", 'scored=scoring("X", lambda *_: 1)', "scored in different ways"),
        ("run.bumps, of", "float('nan'), of", "no number"),
        ('"A point for each bump."', '""', "wants words for the learner"),
    ],
)
def test_an_author_is_told_what_is_wrong(old: str, new: str, said: str) -> None:
    mark = mark_of(f"{MAP}print('stops: x')\n", CHECK.replace(old, new))
    assert said in mark["ours"]
    assert (mark["results"], mark["score"]) == ([], None)


def test_the_command_line_has_them_in_a_table() -> None:
    rows = text_of(mark_of(f"{MAP}forward(100, 30)\nprint('stops: bored')\n")).splitlines()
    (head,) = (row for row in rows if row.lstrip().startswith("mat"))
    assert head.split("  ")[1] == "mat"
    assert "known [%] <= 0.1" in head
    assert "distance [cm] <= 25" in head
    mats = [row for row in rows if "bored" in row]
    assert len(mats) == 4
    assert mats[0].split()[:4] == ["A", "wall", "ahead", "1"]
    assert "*" in mats[0]
    assert "  * outside its limit" in rows
    assert any(row.startswith("  Score: 0.5 of 1. A point for each bump.") for row in rows)


def test_a_refused_program_has_no_results() -> None:
    mark = mark_of("import gc\n")
    assert (mark["results"], mark["score"]) == ([], None)
