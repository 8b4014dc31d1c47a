"""The last resort of the command line: a parent process that can always end the run.

May import: the standard library, `bugbot.trace`.

A calculation inside C, such as sum(iter(int, 1)), lets no other thread run and looks at
no signal, so nothing inside the process can end it; and an interpreter that crashes
takes everything with it. The command therefore does its work in a forked child, whose
trace is sent to the parent a few times a second. When nothing comes for longer than
even the watchdog waits, or the child dies, the parent reports what has arrived. Where
there is no fork (Windows) the work is done in place, without this last resort.
"""

from __future__ import annotations

import json
import os
import select
import signal
import sys
import threading
from base64 import b64decode, b64encode
from collections.abc import Callable, Iterator
from time import sleep

from bugbot.trace import Trace

__all__ = ["Report", "Work", "supervised"]

_SEND_EVERY_S = 0.25
_GRACE_S = 5.0
"""How much longer than the watchdog the parent waits for a sign of life [s]."""

Work = Callable[[Callable[[Trace], None]], int]
"""Does the work and returns the exit status; is handed what to call with the trace at the start."""

Report = Callable[[Trace], int]
"""Reports a trace to which the parent has put an end; returns the exit status."""


def supervised(work: Work, silent_s: float, report: Report) -> int:
    """Do the work in a child process; the exit status."""
    if not hasattr(os, "fork"):
        return work(lambda _: None)
    reading, writing = os.pipe()
    sys.stdout.flush()
    sys.stderr.flush()
    child = os.fork()
    if child == 0:
        _be_child(work, reading, writing)
    os.close(writing)
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the child's to answer
    trace: Trace | None = None
    silent = False
    try:
        for message in _messages(reading, silent_s + _GRACE_S):
            silent = message is None
            if message is not None:
                trace = _grown(trace, message)
        if silent:
            os.kill(child, signal.SIGKILL)
        status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    finally:
        os.close(reading)
        signal.signal(signal.SIGINT, before)
    if status >= 0 or trace is None:
        return abs(status)
    _put_an_end(trace, silent_s if silent else None)
    return report(trace)


def _put_an_end(trace: Trace, silent_s: float | None) -> None:
    t = trace.events[-1][1] if trace.events else 0.0
    if silent_s is not None:
        words = (
            f"Stopped after {silent_s:g} s inside one calculation of Python's that would not end."
        )
        trace.add("end", t, "limit", words)
        return
    words = "Python itself died: functions went on calling one another, or memory ran out"
    trace.add("fault", t, "RecursionError", words, None, None, f"RecursionError: {words}\n")
    trace.add("end", t, "fault", f"Stopped by an error: {words}")


def _be_child(work: Work, reading: int, writing: int) -> None:
    end_process = os._exit  # during a run the name belongs to the program
    status = 1
    try:
        os.close(reading)
        status = work(lambda trace: _send_from_now_on(trace, writing))
    except BaseException:
        sys.excepthook(*sys.exc_info())
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        end_process(status)


def _send_from_now_on(trace: Trace, writing: int) -> None:
    header = {key: trace.header[key] for key in ("program", "world", "seed")}
    os.write(writing, json.dumps(header).encode() + b"\n")
    threading.Thread(target=_send, args=(trace, writing), daemon=True).start()


def _send(trace: Trace, writing: int) -> None:
    events = points = 0
    while True:
        # The last event may still grow, a print being joined to it: it is sent again.
        begin = max(0, events - 1)
        rows, new = trace.events[begin:], trace.points[points:]
        events, points = begin + len(rows), points + len(new)
        message = json.dumps([begin, rows, b64encode(new.tobytes()).decode("ascii")])
        rest = message.encode() + b"\n"
        while rest:
            rest = rest[os.write(writing, rest) :]
        sleep(_SEND_EVERY_S)


def _messages(reading: int, patience_s: float) -> Iterator[bytes | None]:
    """The child's messages until its end; None, as the last, when it gives no sign of life."""
    rest = b""
    while True:
        if not select.select([reading], [], [], patience_s)[0]:
            yield None
            return
        new = os.read(reading, 1 << 16)
        if not new:
            return
        *whole, rest = (rest + new).split(b"\n")
        yield from whole


def _grown(trace: Trace | None, message: bytes) -> Trace:
    if trace is None:
        return Trace(**json.loads(message))
    begin, rows, points = json.loads(message)
    trace.events[begin:] = map(tuple, rows)
    trace.points.frombytes(b64decode(points))
    return trace
