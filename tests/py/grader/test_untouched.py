"""Programs in which nothing is written yet, and causes that only the starter's own text allows."""

from __future__ import annotations

from typing import Any

import pytest
from judged import failed, statuses

from grader.judge import first_failure, step
from grader.marking import mark_program
from grader.untouched import NOTHING_WRITTEN, is_untouched
from performer.perform import perform

STARTER = """from bugbot import *

SIZE = 5


def side():
    # ---- your part ----
    # At present it does not move.
    length = 0
    # ---- end of your part ----
    return length


forward(50, distance=SIZE + int(side()))
"""
PLAIN = "from bugbot import *\n\n\ndef side():\n    # fill this in\n    return 0\n\n\nstop()\n"


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("", ""),
        ("\n", "\r\n"),
        ("# At present it does not move.", "# a longer remark"),
        ("    length = 0\n", "    length =  0  # to be done\n\n"),
        ("    length = 0\n", "    pass\n    length = 0\n    'a text'\n"),
        ("SIZE = 5", "SIZE = 7"),  # a slider has been moved
        ("forward(50", "forward(60"),  # the given code
    ],
)
def test_nothing_is_written_in_a_part_that_does_what_the_starters_does(
    before: str, after: str
) -> None:
    assert is_untouched(STARTER.replace(before, after) if before else STARTER, STARTER)


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("length = 0", "length = 1"),
        ("    length = 0\n", "    length = 0\n    print(length)\n"),
        ("    length = 0\n", ""),
        ("length = 0", "length = ("),
    ],
)
def test_what_has_been_written_counts(before: str, after: str) -> None:
    written = STARTER.replace(before, after)
    assert not is_untouched(written, STARTER)
    assert not is_untouched(written.replace("# ---- your part ----", ""), STARTER)


def test_a_starter_without_a_part_is_held_against_the_complete_program() -> None:
    assert is_untouched(PLAIN.replace("# fill this in", "pass"), PLAIN)
    assert not is_untouched(PLAIN.replace("return 0", "return 1"), PLAIN)
    assert not is_untouched(PLAIN.replace("stop()", "pass"), PLAIN)
    assert not is_untouched(PLAIN, "")
    assert not is_untouched("x = (", "x = (")
    assert not is_untouched(PLAIN, f"# ---- your part ----\n{PLAIN}")  # a starter that is no good


CHECK = """
from grader import calls, check, function, mistake

side = function(
    "side()", lambda: 30, mistakes=[mistake("cut off by int()", lambda: 0, where=calls("int"))]
)
SLIPS = [mistake("the drive is cut off", lambda run: run.distance_cm < 10, where=calls("int"))]

@check("The drive")
def drive(task):
    run = task.run("empty", seconds=20, mistakes=SLIPS)
    task.expect(run.distance_cm > 20, expected="a drive", got="none", run=run)

@check("Another drive")
def another(task):
    task.run("empty", seed=2, seconds=20, mistakes=SLIPS)

@check("The side")
def one(task):
    task.call(side)
"""
LESSON: dict[str, Any] = {"slug": "s", "worlds": {}, "starters": {"task": STARTER}}


def marked(program: str, *, until_failed: bool = False) -> dict[str, Any]:
    return mark_program(CHECK, LESSON, "task", program, perform, until_failed=until_failed)


@pytest.mark.parametrize("until_failed", [False, True])
def test_an_untouched_starter_is_told_just_that_and_no_mistake(until_failed: bool) -> None:
    mark = marked(STARTER.replace("At present", "Now"), until_failed=until_failed)
    assert failed(mark)["likely"] == NOTHING_WRITTEN
    whole = marked(STARTER)
    assert statuses(whole) == ["failed", "passed", "failed"]
    assert [each["likely"] for each in whole["checks"]] == [NOTHING_WRITTEN, None, NOTHING_WRITTEN]


def test_the_early_verdict_does_not_count_the_given_code_as_the_learners() -> None:
    """The starter calls int(); the learner does not, and has written something."""
    written = STARTER.replace("length = 0", "length = 2 - 1")
    jobs = step(CHECK, LESSON, "task", written, [])["jobs"]
    results = [perform(job, written) for job in jobs]
    early = first_failure(CHECK, LESSON, "task", written, results)
    assert early is not None
    for mark in (early, step(CHECK, LESSON, "task", written, results)["mark"]):
        assert failed(mark)["got"] == "none"
        assert failed(mark)["likely"] is None
    own = STARTER.replace("length = 0", "length = int(1.5)")
    assert failed(marked(own, until_failed=True))["likely"] == "the drive is cut off"
