"""The judge's side of the dialogue: jobs, results that can't be trusted, faults that are ours."""

from __future__ import annotations

import json
from typing import Any

import pytest
from judged import CELL, RIGHT, failed, marked, statuses

from bugbot import worlds
from grader.judge import step
from grader.marking import mark_program
from performer.perform import perform

LESSON: dict[str, Any] = {"slug": "lesson", "worlds": {}}

BOTH = (
    CELL
    + """
@check("A run")
def run(task):
    task.call(cell_of, 1, 1)
    run = task.run("empty", seed=2, seconds=10)
    run.took(at_most=5)
    task.call(cell_of, 2, 2)
"""
)


def test_all_jobs_are_asked_for_in_one_round_and_the_rest_in_a_second() -> None:
    first = step(BOTH, LESSON, "task", RIGHT, [])
    assert [job["kind"] for job in first["jobs"]] == ["run", "calls"]
    assert len(first["jobs"][1]["groups"]) == 2  # the third check's calls are not complete yet
    results = [perform(job, RIGHT) for job in first["jobs"]]
    second = step(BOTH, LESSON, "task", RIGHT, results)
    assert [len(job["groups"]) for job in second["jobs"]] == [1]
    results += [perform(job, RIGHT) for job in second["jobs"]]
    assert step(BOTH, LESSON, "task", RIGHT, results)["mark"]["passed"]


def test_what_comes_after_the_first_failure_need_not_be_run() -> None:
    done = []

    def noted(job: dict[str, Any], program: str) -> dict[str, Any]:
        done.append(job["kind"])
        return perform(job, program)

    wrong = RIGHT.replace("floor(x", "ceil(x")
    mark = mark_program(BOTH, LESSON, "task", wrong, noted, until_failed=True)
    assert done == ["calls"]
    assert statuses(mark) == ["failed", "not run", "not run"]
    whole = mark_program(BOTH, LESSON, "task", wrong, perform)
    assert failed(mark) == failed(whole)
    assert mark_program(BOTH, LESSON, "task", RIGHT, perform, until_failed=True)["passed"]


def test_jobs_and_results_are_plain_json() -> None:
    jobs = step(BOTH, LESSON, "task", RIGHT, [])["jobs"]
    assert json.loads(json.dumps(jobs)) == jobs
    results = [perform(job, RIGHT) for job in jobs]
    assert json.loads(json.dumps(results)) == results


def test_the_same_seed_is_shifted_for_another_noise() -> None:
    first, other = (seeds_of(RIGHT, shift)["run"] for shift in (0, 1000))
    assert other == first + 1000


def seeds_of(program: str, shift: int = 0) -> dict[str, int]:
    jobs = step(BOTH, LESSON, "task", program, [], shift=shift)["jobs"]
    return {"run": jobs[0]["seed"], "calls": jobs[1]["groups"][0]["seed"]}


def test_noise_comes_from_the_submission() -> None:
    """The same file has the same noise, however its lines end; any other has another."""
    first = seeds_of(RIGHT)
    for same in (
        RIGHT.replace("\n", "\r\n"),
        RIGHT.replace("\n", "\r"),
        f"\ufeff{RIGHT}",
        f"{RIGHT}\n\n",
        RIGHT.rstrip("\n"),
    ):
        assert seeds_of(same) == first
    others = [f"{RIGHT}#{n}\n" for n in range(200)] + [RIGHT.replace("\n", "\n\n", 1)]
    assert len({seeds_of(other)["run"] for other in others} | {first["run"]}) == 202
    assert all(seeds_of(other)["calls"] != first["calls"] for other in others[:5])


def test_a_mark_names_the_seeds_as_the_check_does() -> None:
    for program in (RIGHT, f"{RIGHT}# another\n"):
        assert step(BOTH, LESSON, "task", program, [])["jobs"][0]["number"] == 2


def test_a_world_of_the_lessons_own_is_used() -> None:
    own = {**worlds.load("empty").to_dict(), "name": "own"}
    check = BOTH.replace('"empty"', '"own"')
    assert marked(check, RIGHT, {"own": own})["passed"]


@pytest.mark.parametrize(
    ("change", "got"),
    [
        ({"answers": None}, "garbled"),
        ({"answers": [7, 7]}, "garbled"),
        ({"answers": [{"answers": [7]}] * 2}, "garbled"),
        (
            {"answers": [{"answers": [], "status": "stopped", "message": ""}] * 2},
            "ended before it gave them",
        ),
        ({"answers": [{"answers": [{"value": {"no": 1}}] * 2}] * 2}, "garbled"),
        ({"answers": [{"answers": [{}] * 2}] * 2}, "garbled"),
        ({"answers": [{"status": "finished", "message": "It left."}] * 2}, "It left."),
        ({"answers": None, "died": "time"}, "it did not stop computing"),
        ({"answers": None, "died": "crash"}, "Python itself broke down"),
        ({"answers": None, "died": "The lights went out."}, "The lights went out."),
    ],
)
def test_results_that_make_no_sense_are_the_programs_failure(
    change: dict[str, Any], got: str
) -> None:
    (job,) = step(CELL, LESSON, "task", RIGHT, [])["jobs"]
    result = {**perform(job, RIGHT), **change}
    mark = step(CELL, LESSON, "task", RIGHT, [None, "x", result])["mark"]
    assert got in failed(mark)["got"]
    assert statuses(mark) == ["failed", "not run"]


def test_a_run_that_died_is_told() -> None:
    jobs = step(BOTH, LESSON, "task", RIGHT, [])["jobs"]
    results = [{"id": jobs[0]["id"], "died": "time"}, perform(jobs[1], RIGHT)]
    mark = step(BOTH, LESSON, "task", RIGHT, results)["mark"]
    assert statuses(mark) == ["passed", "passed", "failed"]
    assert failed(mark)["where"]["job"] == jobs[0]["id"]


HEAD = "from grader import check, function, near\n"
GOOD = '@check("It")\ndef it(task):\n    '
F = 'f = function("f(x)", lambda x: x)\n'


@pytest.mark.parametrize(
    ("check", "ours"),
    [
        ("def", "line 1: SyntaxError"),
        ("1 / 0", "line 1: ZeroDivisionError: division by zero"),
        ("x = 1", "names no checks"),
        (f"{HEAD}@check('')\ndef it(task): pass", "line 2: check(title) wants a title"),
        (f"{HEAD}{GOOD}pass\n{GOOD}pass", "two checks with the title 'It'"),
        (f"{HEAD}f = function('f', 1)", "wants something like \"cell_of(x, y)\"; it got 'f'"),
        (f"{HEAD}f = function('f()', 1)", "wants a function that gives what is right"),
        (f"{HEAD}f = function('f()', max, changes='x')", "it has no parameter 'x' to change"),
        (
            f"{HEAD}f = function('f()', max, mistakes=['no'])",
            "what the learner is told, a function",
        ),
        (f"{HEAD}f = function('f()', max, compare=near('1'))", "wants a number for within"),
        (f"{HEAD}{GOOD}task.call('f', 1)", "line 4: task.call(function, …) wants what function(…)"),
        (f"{HEAD}{F}{GOOD}task.call(f, 1, 2)", "line 5: f(x) takes 1; task.call gives it 2"),
        (f"{HEAD}{F}{GOOD}task.call(f, 1, gives=2)", "f(1) is said to give 2, but the reference"),
        (f"{HEAD}{F}{GOOD}task.call(f, 1, world='emty')", "(did you mean 'empty'?)"),
        (f"{HEAD}{GOOD}task.run('mars')", "there is no world 'mars'; there are"),
        (f"{HEAD}{GOOD}task.run('broken')", "worlds/broken.json: title is missing"),
        (f"{HEAD}{GOOD}task.run('empty').fly()", "line 4: AttributeError"),
        (
            f"{HEAD}f = function('f(x)', lambda x: 1 / x)\n{GOOD}task.call(f, 0)",
            "the reference for f(0) raised ZeroDivisionError: division by zero",
        ),
        (
            f"{HEAD}import random\n{GOOD}for n in range(9):"
            "\n        task.run('empty', 1, random.random())",
            "ask for something else each time",
        ),
    ],
)
def test_a_fault_of_a_check_is_ours_and_never_the_learners(check: str, ours: str) -> None:
    mark = marked(check, "def f(x):\n    return x\n", {"broken": {"name": "broken"}})
    assert mark["ours"] is not None
    assert mark["ours"].startswith("lessons/lesson/task/check.py")
    assert ours in mark["ours"]
    assert not mark["passed"]
    assert "failed" not in statuses(mark)
