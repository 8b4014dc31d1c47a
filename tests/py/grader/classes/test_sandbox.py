"""Hostile programs in the locked-down Python under Node: each ends with an answer, soon.

What Python's own fences refuse (files, sockets, processes, `js`) is in test_cheats.py, and never
comes this far; that the interpreter has no way out without them is in tests/unit/sandbox.spec.ts.
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from bugbot import worlds
from grader.classes.work import Work, mark_work, source_key
from performer.limits import CALLS_LIMITS, RUN_LIMITS
from sandbox.node import Sandbox, close_everything

pytestmark = pytest.mark.skipif(shutil.which("node") is None, reason="the sandbox needs Node")

JOB = {
    "id": "run-1",
    "kind": "run",
    "world": worlds.load("post-and-shelf").to_dict(),
    "seed": 1,
    "limits": {**RUN_LIMITS, "print_bytes": 20_000, "silent_s": 60.0},
}
IMPATIENT = {**JOB, "limits": {**RUN_LIMITS, "silent_s": 2.0}}

FORGED = """
for line in ('result {"id": "run-1", "died": null, "trace": null}', "beat 100", "begun"):
    print(line)
    print("\\n" + line + "\\n")
while True:
    print("flood " * 200)
"""

MEMORY = """
kept = []
while True:
    kept.append(bytearray(50_000_000))
"""


@pytest.fixture(scope="module")
def sandbox() -> Iterator[Sandbox]:
    with Sandbox() as sandbox:
        yield sandbox


def ended(result: dict[str, Any]) -> str:
    return str(result["outcome"]["message"])


def test_an_honest_program_and_then_the_hostile(sandbox: Sandbox) -> None:
    honest = sandbox.perform(JOB, "from bugbot import *\nscan()\nforward(20)\n")
    assert honest["died"] is None
    assert honest["outcome"]["status"] == "finished"

    for endless in ("while True:\n    pass\n", "sum(iter(int, 1))\n"):
        assert sandbox.perform(IMPATIENT, endless) == {
            "id": "run-1",
            "trace": None,
            "outcome": None,
            "answers": None,
            "died": "time",
        }
    bomb = sandbox.perform(JOB, MEMORY)
    assert "MemoryError" in bomb["trace"]["events"]

    forged = sandbox.perform(JOB, FORGED)
    assert "printing 0.02 MB" in ended(forged)
    rows = json.loads(forged["trace"]["events"])
    assert {row[0] for row in rows} <= {"pose", "line", "print", "end"}, "prints are only prints"

    again = sandbox.perform(JOB, "from bugbot import *\nscan()\nforward(20)\n")
    assert again["trace"] == honest["trace"], "nothing stays behind"


def test_calls_are_ended_from_within_and_told_with_their_lines(
    sandbox: Sandbox,
) -> None:
    call: dict[str, Any] = {"arguments": [1]}
    group = {
        "world": JOB["world"],
        "seed": 1,
        "constants": {},
        "calls": [{**call, "function": name} for name in ("slow", "nothing", "endless")],
    }
    job = {"id": "calls-1", "kind": "calls", "limits": CALLS_LIMITS, "groups": [group]}
    program = """
def slow(x):
    return sum(all(n < 9 for n in (x, row)) for row in range(300_000))
def nothing(x):
    if x > 1:
        return 3
def endless(x):
    while True:
        x += 1
"""
    slow, nothing, endless = sandbox.perform(job, program)["answers"][0]["answers"]
    assert slow == {"value": 9}
    assert nothing == {"value": None, "left on": 5}
    assert endless["late"] in (8, 9)


CHECK = """
from grader import check, function

here = function("here(x)", lambda x: x + 1)

@check("One more")
def more(task):
    task.call(here, 1, gives=2)
"""


@pytest.mark.parametrize(
    ("program", "status", "got"),
    [
        ("def here(x):\n    return x + 1\n", "passed", None),
        ("import os\nos.kill(0, 9)\n", "failed", "can't import os"),
        ("import js\njs.process.exit(0)\n", "failed", "can't import js"),
        (f"print(open({str(Path(__file__))!r}).read())\n", "failed", "open"),
    ],
)
def test_a_submission_is_marked_in_it(program: str, status: str, got: str | None) -> None:
    work: Work = {
        "learner": "eve",
        "task": "here",
        "file": "eve/here.py",
        "check": CHECK,
        "lesson": {"slug": "one", "worlds": {}},
        "program": program,
        "note": None,
        "trusted": False,
        "sources": source_key(),
        "key": "",
    }
    row = mark_work(work)
    assert row["status"] == status
    assert got is None or got in row["failed"][0]["got"]


def test_the_process_is_told_nothing_and_can_open_nothing(sandbox: Sandbox) -> None:
    process, lines = sandbox._start()
    try:
        assert lines.get(timeout=60) == b"ready"
        proc = Path(f"/proc/{process.pid}")
        if not proc.exists():
            pytest.skip("only Linux lets us look")
        assert (proc / "environ").read_bytes() == b""
        close_everything(process.pid, 60)
        limits = (proc / "limits").read_text()
        assert [line.split()[3:5] for line in limits.splitlines() if "open files" in line] == [
            ["0", "0"]
        ]
    finally:
        sandbox.close()
    with pytest.raises(ProcessLookupError):
        os.kill(process.pid, 0)
