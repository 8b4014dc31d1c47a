"""What a check can expect of a run: its map, its chart, its drive, its prints."""

from __future__ import annotations

from pathlib import Path

import pytest
from judged import failed, marked, statuses

DEMO = (
    Path(__file__).parents[3] / "lessons/occupancy-grid-mapping/programs/demo-1-from-one-spot.py"
).read_text("utf-8")

HEAD = """
from grader import check

@check("It", hint=2)
def it(task):
    run = task.run("wall-ahead", seed=5, seconds=20)
    """


def judged(expectation: str, program: str) -> dict[str, object] | None:
    """The failed check with one expectation of a run, or None if it passes."""
    mark = marked(HEAD + expectation + "\n", "from bugbot import *\n" + program)
    return None if mark["passed"] else failed(mark)


SQUARES = 'draw("free", [(102.5, 62.5)], "blue", "squares", 5)\n'
WALL = 'draw("occupied", [(102.5, 152.5)], "black", "squares", 5)\n'
MAP = f"scan()\n{SQUARES}{WALL}"
"""Two cells drawn, and a single look that no beam of which ends in the second one."""


@pytest.mark.parametrize(
    ("expectation", "program"),
    [
        ("run.map().known(at_least=0.05, at_most=1).wrong_walls(at_most=0)", MAP),
        ("run.map().wrong_floor(at_most=0).cells_of(5)", MAP),
        ('run.map().cell(101, 61, "free").cell(101, 151, "occupied").cell(1, 1, "unknown")', MAP),
        ("run.map(at=1).known(at_least=0.05)", f"{MAP}wait(2)\n{MAP}"),
        (
            'run.map(free="floor", occupied="occupied").known(0.05)',
            MAP.replace('"free"', '"floor"'),
        ),
        ('assert run.layer("free") == [(102.5, 62.5)]', MAP),
        (
            'run.line("a").ends(at_least=2, at_most=2).reaches(2, by=1).stays(at_least=1)',
            "plot('a', 1)\nwait(1)\nplot('a', 2)",
        ),
        ('run.line("a").reaches(0)', "plot('a', 1)\nwait(1)\nplot('a', -1)"),
        (
            'l = run.line("a"); assert (l.at(0.5), l.end, l.highest, l.lowest) == (1, 2, 2, 1)',
            "plot('a', 1)\nwait(1)\nplot('a', 2)",
        ),
        ('run.prints("hello").took(at_most=1)', "print('hello')"),
        (
            'assert run.number_after("drift:") == -0.25',
            "print('drift: 7')\nprint('drift: -0.25 degrees')",
        ),
        ('assert run.number_after("drift 2:") == 5', "print('drift ', 2, ':', 5)"),
        ('run.visits(lambda x, y: y > 60, "up there", by=10).never_bumps()', "forward(100, 30)"),
        ("run.scanned(at_least=2)", "scan()\ndistance()"),
        ("assert run.pose_at(0) == (100, 40, 0) and run.start.x == 100", "turn(90)"),
        ('task.near(run.seconds, 3, 0.01, "the time", run=run)', "wait(3)"),
        ("assert 0.15 <= abs(run.drift) <= 0.25 and run.obstacles == [(0, 150, 200, 8)]", ""),
        ('task.expect(run.scans[0].beams[0][1] > 100, expected="far", got="near")', "scan()"),
    ],
)
def test_an_expectation_that_is_met(expectation: str, program: str) -> None:
    assert judged(expectation, program) is None


@pytest.mark.parametrize(
    ("expectation", "program", "expected", "got"),
    [
        ("run.map().known(at_least=50)", MAP, "at least 50 % of the mat known", "0.1 %"),
        ("run.map().known(at_most=0.05)", MAP, "at most 0.05 % of the mat known", "0.1 %"),
        (
            "run.map().wrong_walls(at_most=10)",
            f"scan()\n{SQUARES}{WALL.replace('152.5', '102.5')}",
            "at most 10 % of the occupied cells more than a cell from anything real",
            "100.0 %: 1 of 1 cell",
        ),
        (
            "run.map().wrong_floor(at_most=10)",
            f"scan()\n{SQUARES.replace('62.5', '152.5')}{WALL.replace('102.5', '107.5')}",
            "at most 10 % of the free cells inside something solid",
            "100.0 %: 1 of 1 cell",
        ),
        ("run.map().cells_of(10)", MAP, "cells of 10 cm", "cells of 5 cm"),
        ('run.map().cell(101, 61, "occupied")', MAP, "an occupied cell at (101, 61)", "free"),
        ("run.map()", SQUARES, 'a layer named "occupied"', 'the only layer is "free"'),
        (
            "run.map()",
            MAP.replace("squares", "dots"),
            'the layer "free" drawn as squares',
            "it is drawn as dots",
        ),
        (
            "run.map()",
            MAP.replace('"squares", 5)', '"squares", 10)', 1)
            .replace("62.5", "65")
            .replace("(102.5, 65", "(105, 65"),
            "all layers of the map with cells of one size",
            'the squares of "occupied" are 5 cm wide, the others 10',
        ),
        (
            "run.map()",
            MAP.replace('"squares", 5', '"squares", 0.5'),
            'squares as large as a cell in the layer "free"',
            "squares of 0.5 cm",
        ),
        (
            "run.map()",
            MAP.replace("62.5", "60"),
            'each square of the layer "free" in the middle of a cell of 5 cm',
            "the square at (102.5, 60) is not in the middle of a cell",
        ),
        (
            "run.map()",
            MAP.replace("62.5", "262.5").replace("102.5, 262.5", "-2.5, 62.5"),
            'each square of the layer "free" in the middle of a cell of 5 cm',
            "the square at (-2.5, 62.5) is beyond the mat",
        ),
        (
            "run.map()",
            MAP.replace("152.5", "62.5"),
            "each cell either free or occupied",
            "1 cell is drawn as both",
        ),
        ('run.layer("goal")', MAP, 'a layer named "goal"', 'the layers are "free" and "occupied"'),
        (
            'run.line("known %")',
            "plot('known', 1)",
            'a line named "known %"',
            'the only line in the chart is "known"',
        ),
        (
            'run.line("a").ends(at_least=2)',
            "plot('a', 1)",
            'a line "a" that ends at 2 or above',
            "1 at 0.00 s",
        ),
        (
            'run.line("a").stays(at_most=0)',
            "plot('a', 1)",
            'a line "a" that stays at 0 or below',
            "1 at 0.00 s",
        ),
        (
            'run.line("a").reaches(5, by=2)',
            "plot('a', 1)\nwait(3)\nplot('a', 6)",
            'the line "a" to reach 5 by 2 s',
            "it only gets to 1",
        ),
        (
            'run.line("a").follows(run.evidence_at(100, 100), 0.1)',
            "plot('a', 1)",
            'the line "a" at 0.000 after 0.00 s',
            "1.000",
        ),
        (
            'run.prints("hello")',
            "print('HELLO')",
            "a printed line with 'hello'",
            "the last line printed is 'HELLO'",
        ),
        ('run.number_after("drift:")', "", "a number printed after 'drift:'", "nothing is printed"),
        (
            'run.visits(lambda x, y: y > 60, "up there", by=1)',
            "wait(2)",
            "the robot to reach up there within 1 s",
            "it never got there, and ended at (100, 40)",
        ),
        (
            'run.visits(lambda x, y: y > 60, "up there", by=1)',
            "forward(50)\nwait(9)",
            "the robot to reach up there within 1 s",
            "it got there after 3.5 s",
        ),
        (
            "run.never_bumps()",
            "backward(100, 60)",
            "the robot to touch nothing",
            "it touched something once, first at 3.1",
        ),
        ("run.took(at_most=1)", "wait(2)", "a run of at most 1 s", "2.0 s"),
        ("run.scanned(at_least=1)", "wait(2)", "at least 1 scan", "0"),
        ("run.scanned(at_least=2)", "scan()", "at least 2 scans", "1"),
        (
            'task.near(run.seconds, 3, 0.5, "the time", run=run)',
            "wait(2)",
            "the time is 3, give or take 0.5",
            "2.0",
        ),
        ('task.expect(False, expected="far", got="near")', "", "far", "near"),
    ],
)
def test_an_expectation_that_is_not_met(
    expectation: str, program: str, expected: str, got: str
) -> None:
    first = judged(expectation, program)
    assert first is not None
    assert str(first["expected"]).startswith(expected)
    assert str(first["got"]).startswith(got)
    assert first["hint"] == 2


def test_the_four_cells_of_evidence_can_be_followed() -> None:
    program = """
from bugbot import *
l = 0.0
for _ in range(5):
    for angle, reading in scan()[3:5]:
        if 150 <= 40 + reading < 155:
            l += 0.85
    plot("wall", l)
    wait(0.1)
"""
    expectation = """seen = run.evidence_at(97.5, 152.5)
    assert seen[0] == (0.0, 0.0) and len(seen) == 6
    run.line("wall").follows([(t, l) for t, l in run.evidence_at(102.5, 152.5)], within=100)"""
    assert judged(expectation, program) is None


# -- maps of a real mapper ---------------------------------------------------------

SLIPS = """
from grader import check
from mapping.beam import Weights

SLIPS = [
    ("sine and cosine look swapped", lambda run: run.map().looks_like(run.mapped(
        seen_as=lambda x, y, heading, angle, reading: (x, y, 90 - heading, -angle, reading)))),
    ("left out", lambda run: run.map().looks_like(run.mapped(
        seen_as=lambda x, y, heading, angle, reading:
            None if angle < 0 else (x, y, heading, angle, reading))), 1),
    ("the maximum taken for a wall", lambda run: run.map().looks_like(run.mapped(
        weights=Weights(far_cm=1000)))),
]

@check("Enough is known", hint=0)
def enough(task):
    run = task.run("post-and-shelf", seed=11, seconds=60, mistakes=SLIPS)
    run.map().known(at_least=55).wrong_walls(at_most=3)

@check("It says what its scans say", hint=2)
def agrees(task):
    run = task.run("post-and-shelf", seed=11, seconds=60, mistakes=SLIPS)
    run.map().agrees(run.mapped(), at_least=95)
"""


def changed(*pairs: tuple[str, str]) -> str:
    program = DEMO
    for before, after in pairs:
        assert before in program
        program = program.replace(before, after)
    return program


def test_a_good_map_passes_and_its_run_is_made_once() -> None:
    assert marked(SLIPS, DEMO)["passed"]


@pytest.mark.parametrize(
    ("pairs", "likely", "hint"),
    [
        ([("dx = math.sin", "dx = math.cos"), ("dy = math.cos", "dy = math.sin")], "sine and", 0),
        ([("in scan():", "in scan()[4:]:"), ("SECONDS = 13", "SECONDS = 5")], "left out", 1),
        ([("SECONDS = 13", "SECONDS = 3")], None, 0),
    ],
)
def test_the_slip_that_makes_the_same_map_is_named(
    pairs: list[tuple[str, str]], likely: str | None, hint: int
) -> None:
    first = failed(marked(SLIPS, changed(*pairs)))
    assert first["title"] == "Enough is known"
    assert (first["likely"] or "").startswith(likely or "")
    assert (first["likely"] is None) is (likely is None)
    assert first["hint"] == hint
    assert first["where"]["cells"]
    assert first["where"]["seconds"] > 2


def test_a_map_that_scans_do_not_bear_out_is_told_apart() -> None:
    shifted = changed(("(cell % ACROSS + 0.5)", "((cell + 3) % ACROSS + 0.5)"))
    mark = marked(SLIPS, shifted)
    assert statuses(mark)[1] == "failed"
    assert mark["checks"][1]["expected"].startswith("a map that agrees with its scans")
    assert mark["checks"][1]["where"]["cells"]


def test_a_map_of_what_was_never_seen_is_refused_even_if_it_is_right() -> None:
    program = changed(("right(30)", "log_odds = [-3.0] * 1600\nright(30)"))
    first = failed(marked(SLIPS, program))
    assert first["expected"] == "a map of what the beams of this run have seen"
    assert first["likely"] is None
    assert len(first["where"]["cells"]) > 100
