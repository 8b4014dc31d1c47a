"""The parent process of the command line; `test_cli.py` has it end real programs."""

import os
import signal
from collections.abc import Callable

import pytest

from bugbot import supervisor
from bugbot.supervisor import supervised
from bugbot.trace import Trace

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork here")


def never(trace: Trace) -> int:
    raise AssertionError("nothing to report")


def empty_trace() -> Trace:
    return Trace("", {}, 0)


@pytest.mark.parametrize("status", [0, 1, 2])
def test_the_childs_status_is_passed_on(status: int) -> None:
    assert supervised(lambda _: status, 1, never) == status


def test_an_error_in_the_work_is_a_failure() -> None:
    def work(_: object) -> int:
        raise RuntimeError

    assert supervised(work, 1, never) == 1


def test_a_child_that_dies_before_it_has_begun_is_a_failure() -> None:
    def work(_: object) -> int:
        os.kill(os.getpid(), signal.SIGKILL)
        return 0

    assert supervised(work, 1, never) == signal.SIGKILL


class Sent:
    """Stands in for os.write in the child and knows how many messages have gone out."""

    def __init__(self) -> None:
        self._write = os.write
        self._count = 0

    def __call__(self, file: int, data: bytes) -> int:
        written = self._write(file, data)
        self._count += 1
        return written

    def wait_for(self, more: int) -> None:
        goal = self._count + more
        while self._count < goal:
            pass


def test_what_a_killed_child_had_recorded_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    """The child records, waits until that has been sent, records more, waits again, and dies."""
    monkeypatch.setattr(supervisor, "_SEND_EVERY_S", 0.01)
    reports: list[Trace] = []

    def report(trace: Trace) -> int:
        reports.append(trace)
        return 7

    def work(follow: Callable[[Trace], None]) -> int:
        sent = Sent()
        monkeypatch.setattr(os, "write", sent)
        trace = empty_trace()
        follow(trace)
        trace.write(1, "stdout", "a")
        trace.layer(1, "dots", [(1, 2)], "red", "dots", 2)
        sent.wait_for(2)
        trace.layer(2, "dots", [(3, 4), (5, 6)], "red", "dots", 2)
        trace.write(2, "stdout", "b")
        sent.wait_for(2)
        trace.write(2, "stdout", "c")
        sent.wait_for(2)
        os.kill(os.getpid(), signal.SIGKILL)
        return 0

    assert supervised(work, 30, report) == 7
    (trace,) = reports
    assert trace.events[:4] == [
        ("print", 1, "stdout", "a"),
        ("layer", 1, "dots", "red", "dots", 2, 0, 1, None),
        ("layer", 2, "dots", "red", "dots", 2, 1, 2, None),
        ("print", 2, "stdout", "bc"),
    ]
    assert list(trace.points) == [100, 200, 300, 400, 500, 600]
    assert [event[0] for event in trace.events[4:]] == ["fault", "end"]
    assert trace.events[-1][1:3] == (2, "fault")


def test_without_fork_the_work_is_done_in_place(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(os, "fork")
    here = os.getpid()
    assert supervised(lambda send: (send(empty_trace()), os.getpid())[1], 1, never) == here
