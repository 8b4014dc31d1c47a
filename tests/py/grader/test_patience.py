"""A program is ended for computing too long, not for what a busy machine keeps it waiting.

Where no timer interrupts Python, as on Windows, the program is followed line by line instead.
"""

from __future__ import annotations

import itertools
import signal
import sys
from queue import Queue
from typing import Any

import pytest

from bugbot import worlds
from performer import calling, patience
from performer import perform as performing
from performer.limits import CALL_S, CALLS_LIMITS, FEW_LINES_A_S, SLOW
from performer.perform import perform
from sandbox.node import _answer

timers = pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="there is no timer")


def reply_to(program: str, *arguments: Any) -> dict[str, Any]:
    """What the performer tells of `there` called with these."""
    group = {
        "world": worlds.load("empty").to_dict(),
        "seed": 1,
        "constants": {},
        "calls": [{"function": "there", "arguments": list(arguments)}],
    }
    job = {"id": "calls-1", "kind": "calls", "limits": CALLS_LIMITS, "groups": [group]}
    replies: list[dict[str, Any]] = perform(job, program)["answers"]
    return replies[0]


def answer_of(body: str) -> dict[str, Any]:
    """What `there(1)` answers where it has this body."""
    program = f"def there(x):\n    for _ in range(x):\n        pass\n    {body}\n"
    answer: dict[str, Any] = reply_to(program, 1)["answers"][0]
    return answer


@pytest.fixture
def no_timer(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(signal, "setitimer", raising=False)


def slow_clock(monkeypatch: pytest.MonkeyPatch, step_s: float) -> None:
    """Each look at the clock finds that so much has passed."""
    moments = itertools.count()
    monkeypatch.setattr(patience, "cpu_time", lambda: next(moments) * step_s)


@pytest.mark.usefixtures("no_timer")
def test_few_lines_may_take_longer_than_many(monkeypatch: pytest.MonkeyPatch) -> None:
    # A few looks, and more than the patience each: somebody else has the processor.
    slow_clock(monkeypatch, 1.1 * CALL_S)
    assert answer_of("for _ in range(40): x += 1\n    return x")["value"] == 41


@pytest.mark.usefixtures("no_timer")
def test_but_not_for_ever(monkeypatch: pytest.MonkeyPatch) -> None:
    slow_clock(monkeypatch, SLOW * CALL_S / 2)
    assert "late" in answer_of("for _ in range(60): x += 1\n    return x")


@pytest.mark.usefixtures("no_timer")
def test_many_lines_may_not(monkeypatch: pytest.MonkeyPatch) -> None:
    looks = int(FEW_LINES_A_S * CALL_S) // 16
    slow_clock(monkeypatch, 1.1 * CALL_S / looks)
    assert answer_of("while True: x += 1") == {"late": 4}


@pytest.mark.usefixtures("no_timer")
def test_without_a_timer_the_line_that_gave_none_is_told() -> None:
    assert answer_of("return") == {"value": None, "left on": 4}


# -- with a timer ----------------------------------------------------------------

ENDLESS = [
    ("def there(x):\n    while True:\n        x += 1\n", (2, 3)),
    ("def there(x):\n    return all(n >= 0 for n in iter(int, 1))\n", (2,)),
    (
        "def there(x):\n    while True:\n        inner(x)\ndef inner(x):\n    x\n",
        (2, 3, 4, 5),
    ),
    (
        "import copy\ndef there(x):\n    while True:\n        copy.deepcopy([[x]] * 99)\n",
        (3, 4),
    ),
    (
        "def there(x):\n    while True:\n        try:\n            while True:\n"
        "                x += 1\n        except BaseException:\n            pass\n",
        (4, 5, 6, 7),
    ),
]


@timers
@pytest.mark.parametrize(("program", "lines"), ENDLESS)
def test_what_never_ends_is_ended_on_a_line_of_its_own(
    monkeypatch: pytest.MonkeyPatch, program: str, lines: tuple[int, ...]
) -> None:
    monkeypatch.setattr(calling, "CALL_S", 0.02)
    before = sys.gettrace()
    assert reply_to(program, 1)["answers"][0]["late"] in lines
    assert sys.gettrace() == before
    assert signal.getitimer(signal.ITIMER_PROF)[0] == 0


@timers
def test_a_program_that_never_ends_is_told_with_its_line(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(performing, "PROGRAM_S", 0.02)
    program = "def there(x):\n    return x\nn = 0\nwhile True:\n    n += 1\n"
    reply = reply_to(program, 7)
    assert reply["answers"] == [{"value": 7}]
    assert reply["message"] in [
        f"Stopped on line {line} after 0.02 s of computing: it is very slow, or it has a loop "
        "that never ends."
        for line in (4, 5)
    ]


@timers
def test_a_program_is_not_followed_while_it_has_time(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    lines: list[int] = []
    follow = patience.Patience._on_line

    def noted(self: Any, frame: Any, event: str, argument: Any) -> Any:
        lines.append(frame.f_lineno)
        return follow(self, frame, event, argument)

    monkeypatch.setattr(patience.Patience, "_on_line", noted)
    program = "def there(x):\n    for _ in range(1000):\n        x += 1\n    return x\n"
    assert reply_to(program, 1)["answers"] == [{"value": 1001}]
    assert lines == []


@timers
@pytest.mark.parametrize(
    ("body", "line"),
    [("return", 5), ("if x > 1:\n        return 3", 5), ("[n for n in (1, 2)]", 5)],
)
def test_the_line_that_gave_none_is_told(body: str, line: int) -> None:
    program = f"def double(n):\n    return 2 * n\ndef there(x):\n    double(x)\n    {body}\n"
    assert reply_to(program, 1)["answers"] == [{"value": None, "left on": line}]


# -- the limit of a job ------------------------------------------------------------

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
