"""The performer's process: fresh for each job, ended when it takes too long or breaks."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from judged import CELL, RIGHT, failed

from grader.judge import step
from grader.marking import Performer, mark_program
from performer import serving

LESSON: dict[str, Any] = {"slug": "lesson", "worlds": {}}


@pytest.fixture(scope="module")
def performer() -> Iterator[Performer]:
    with Performer() as performer:
        yield performer


def job_of(program: str, **limits: float) -> dict[str, Any]:
    job: dict[str, Any] = step(CELL, LESSON, "task", program, [])["jobs"][0]
    return {**job, "limits": {**job["limits"], **limits}}


def test_each_job_finds_a_fresh_interpreter(performer: Performer) -> None:
    spoiled = "import math\nmath.floor = round\ndef cell_of(x, y):\n    return math.floor(x), 0\n"
    for program, passes in ((RIGHT, True), (spoiled, False), (RIGHT, True)):
        mark = mark_program(CELL, LESSON, "task", program, performer.perform)
        assert mark["passed"] is passes


def test_a_calculation_that_nothing_interrupts_is_ended(performer: Performer) -> None:
    endless = "def cell_of(x, y):\n    return sum(iter(int, 1))\n"
    result = performer.perform(job_of(endless, real_s=0.5), endless)
    assert result["died"] == "time"
    assert performer.perform(job_of(RIGHT), RIGHT)["died"] is None


def test_an_interpreter_that_breaks_down_is_told(performer: Performer) -> None:
    # More memory than a job may have, where even saying so needs some.
    greedy = "def cell_of(x, y):\n    return bytearray(10 ** 12)\n"
    mark = mark_program(CELL, LESSON, "task", greedy, performer.perform)
    assert failed(mark)["got"].startswith("MemoryError on line 2")
    job = job_of(RIGHT)
    assert performer.perform({**job, "kind": "calls", "groups": [{}]}, RIGHT)["died"] == "crash"
    assert performer.perform(job, RIGHT)["died"] is None


@pytest.mark.parametrize(
    ("line", "died"),
    [
        # Of another job, whose program has left it behind: passed over.
        (b'{"id": "another"}\n', None),
        (b'{"over": 0}\n', None),
        (b"[]\n", None),
        (b"no json\n", "crash"),
        (b"", "crash"),
    ],
)
def test_an_answer_for_another_job_is_none(
    performer: Performer, line: bytes, died: str | None
) -> None:
    performer.close()
    performer._started()
    performer._lines.put(line)
    assert performer.perform(job_of(RIGHT), RIGHT)["died"] == died


def test_a_performer_can_import_neither_the_judge_nor_the_reference(performer: Performer) -> None:
    """Even without what refuses it: they are not where Python looks."""
    server = performer._started()
    code = "import sys; sys.modules['performer.serving'] = sys\n"
    code += "sys.serve = lambda: [print(m, *u.find_spec(m) and ['there'] or []) for m in NAMES]\n"
    code += "import importlib.util as u; NAMES = ('bugbot', 'performer', 'grader', 'mapping')\n"
    *command, program, folder = map(str, server.args)  # type: ignore[union-attr]
    done = subprocess.run(
        [*command, code + program, folder], capture_output=True, text=True, check=True, env={}
    )
    assert done.stdout.split("\n") == ["bugbot there", "performer there", "grader", "mapping", ""]


def test_a_server_that_is_gone_is_started_again(performer: Performer) -> None:
    server = performer._started()
    server.kill()
    server.wait()
    assert performer.perform(job_of(RIGHT), RIGHT)["died"] is None


def test_the_server_has_no_judge_in_it() -> None:
    code = (
        "import sys, performer.serving;"
        "print(sorted(name for name in sys.modules if 'mapping' in name or 'judge' in name))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "PYTHONPATH": str(Path(serving.__file__).parents[1])},
    )
    assert done.stdout.strip() == "[]"


def test_without_fork_one_job_is_done_and_the_server_is_gone(tmp_path: Path) -> None:
    job = job_of(RIGHT)
    requests = (json.dumps({"job": job, "program": RIGHT, "turn": 1}) + "\n") * 2
    code = "import os; del os.fork; from performer.serving import serve; serve()"
    done = subprocess.run(
        [sys.executable, "-c", code],
        input=requests,
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "PYTHONPATH": str(Path(serving.__file__).parents[1])},
    )
    (answer,) = done.stdout.splitlines()
    assert json.loads(answer)["id"] == job["id"]
