"""A job of a marking in the browser. Jobs and results cross the page as JSON made and read in
Python, so that 12.0 does not become 12 on the way through JavaScript.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable

from bugbot import clock
from performer.perform import perform as do

__all__ = ["perform"]

real_time = time.perf_counter
"""Kept before a run puts simulated time in its place."""

BEAT_SECONDS = 0.2
"""How often the page hears how far a run is."""


def perform(job: str, program: str, beat: Callable[[float], None], look: Callable[[], None]) -> str:
    """Do one job, given as JSON, with the program; the result as JSON.

    `beat(t)` hears now and then the simulated time that a run has come to [s]: nothing here can
    end a program that computes for ever, so the page does if it no longer hears time pass.
    `look()` has Python look at the clock from now on, which calls of functions need: they are
    ended from within.
    """
    due = 0.0

    def on_flush() -> None:
        nonlocal due
        if real_time() >= due:
            due = real_time() + BEAT_SECONDS  # first: clock() is a call that flushes
            beat(clock())

    asked = json.loads(job)
    if asked["kind"] == "calls":
        look()
    return json.dumps(do(asked, program, on_flush))
