"""A program is ended for computing too long, not for what a busy machine keeps it waiting."""

from __future__ import annotations

import itertools
from queue import Queue
from typing import Any

import pytest

from bugbot import worlds
from performer import calling
from performer.limits import CALL_S, CALLS_LIMITS, FEW_LINES_A_S, SLOW
from performer.perform import perform
from sandbox.node import _answer


def answer_of(body: str) -> dict[str, Any]:
    """What `there(1)` answers where it has this body."""
    group = {
        "world": worlds.load("empty").to_dict(),
        "seed": 1,
        "constants": {},
        "calls": [{"function": "there", "arguments": [1]}],
    }
    job = {"id": "calls-1", "kind": "calls", "limits": CALLS_LIMITS, "groups": [group]}
    program = f"def there(x):\n    for _ in range(x):\n        pass\n    {body}\n"
    answers: list[dict[str, Any]] = perform(job, program)["answers"][0]["answers"]
    return answers[0]


def slow_clock(monkeypatch: pytest.MonkeyPatch, step_s: float) -> None:
    """Each look at the clock finds that so much has passed."""
    moments = itertools.count()
    monkeypatch.setattr(calling, "cpu_time", lambda: next(moments) * step_s)


def test_few_lines_may_take_longer_than_many(monkeypatch: pytest.MonkeyPatch) -> None:
    # Five lines, each of half the patience: somebody else has the processor.
    slow_clock(monkeypatch, CALL_S / 2)
    assert answer_of("return x") == {"value": 1}


def test_but_not_for_ever(monkeypatch: pytest.MonkeyPatch) -> None:
    slow_clock(monkeypatch, SLOW * CALL_S / 2)
    assert "late" in answer_of("return x")


def test_many_lines_may_not(monkeypatch: pytest.MonkeyPatch) -> None:
    lines = int(FEW_LINES_A_S * CALL_S)
    slow_clock(monkeypatch, 1.1 * CALL_S / lines)
    assert "late" in answer_of("while True: x += 1")


JOB = {"id": "run-1", "kind": "run", "limits": {"real_s": 60.0, "silent_s": 0.01}}


def test_a_process_that_is_kept_waiting_has_its_time() -> None:
    lines: Queue[bytes] = Queue()
    looks = iter(range(100))

    def computed_s() -> float:
        # It gets no time of the processor, and then it is done.
        if next(looks) == 4:
            lines.put(b'result {"id": "run-1"}')
        return 0.0

    assert _answer(JOB, lines, computed_s) == {"id": "run-1"}


def test_a_process_that_computes_and_says_nothing_is_ended() -> None:
    moments = itertools.count(step=0.004)
    assert _answer(JOB, Queue(), lambda: next(moments))["died"] == "time"
