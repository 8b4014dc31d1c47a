"""One run in the browser: takes the program in, sends the trace out as it grows."""

from __future__ import annotations

import json
import signal
import time
from collections.abc import Callable

from bridge.imports import missing_modules
from bridge.kept import Kept
from bugbot.run import Limits, run_program
from bugbot.trace import Trace

__all__ = ["missing_modules", "run"]

signal.signal(signal.SIGINT, signal.SIG_IGN)
# The worker presses Ctrl-C to have the watchdog look at the clock. Before and after the program
# nobody listens, and Python's own answer would be a KeyboardInterrupt in the middle of our code.

real_time = time.perf_counter
"""Kept before a run puts simulated time in its place."""

FLUSH_SECONDS = 0.016
"""What was recorded goes to the page at most once a frame."""


class _Sender:
    """Sends what a trace has gathered, at most once a frame."""

    def __init__(self, send: Callable[[str, bytes], None], kept: Kept) -> None:
        self._send = send
        self._kept = kept
        self._trace: Trace | None = None
        self._sent_at = 0.0

    def follow(self, trace: Trace) -> None:
        self._trace = trace

    def flush_if_due(self) -> None:
        if real_time() - self._sent_at >= FLUSH_SECONDS:
            self.flush()

    def flush(self) -> None:
        if self._trace is not None:
            events, points = self._trace.take()
            self._send(events, points)
            self._kept.sent()
        self._sent_at = real_time()


def run(
    program: str,
    world_json: str,
    seed: int,
    limits_json: str,
    send: Callable[[str, bytes], None],
    begin: Callable[[float, str], None],
    keep: Callable[[str], None],
    still: Callable[[int], None],
) -> None:
    """Run a program and send its trace; the last chunk holds the end event.

    `send(events, points)` takes the rows as JSON text and the bytes of the new points.
    `begin(t, stream)` and `keep(text)` hear of what is printed at once, in case the interpreter
    breaks before it is sent. `still(line)` hears on which line the program computes while no
    simulated time passes.
    """
    kept = Kept(begin, keep)
    sender = _Sender(send, kept)
    run_program(
        program,
        json.loads(world_json),
        seed,
        limits=Limits(**json.loads(limits_json)),
        trace_ready=sender.follow,
        on_flush=sender.flush_if_due,
        on_print=kept.add,
        on_still=still,
    )
    sender.flush()
