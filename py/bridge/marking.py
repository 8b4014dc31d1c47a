"""A marking in the browser: one worker judges, others do the jobs it asks for.

The page carries the texts between them. Jobs and results cross it as JSON made and
read here, so that 12.0 does not become 12 on the way through JavaScript.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from typing import Any

from bugbot import clock
from grader.judge import step
from grader.perform import perform as do

__all__ = ["Judge", "perform"]

real_time = time.perf_counter
"""Kept before a run puts simulated time in its place."""

BEAT_SECONDS = 0.2
"""How often the page hears how far a run is."""


class Judge:
    """The judge's side of one marking; this interpreter never runs any of the program.

    request  JSON: lesson (its slug), task (its name), check (the text of check.py),
             program, worlds (the lesson's own)
    """

    def __init__(self, request: str) -> None:
        self._request: dict[str, Any] = json.loads(request)
        self._results: list[Any] = []

    def hear(self, result: str) -> None:
        """Take in what a performer said of a job."""
        self._results.append(json.loads(result))

    def step(self) -> str:
        """What comes next, as JSON: {"jobs": [job as text, …]} or {"mark": mark}."""
        request = self._request
        worlds = {world["name"]: world for world in request["worlds"]}
        lesson = {"slug": request["lesson"], "worlds": worlds}
        said = step(request["check"], lesson, request["task"], request["program"], self._results)
        if "jobs" in said:
            return json.dumps({"jobs": [json.dumps(job) for job in said["jobs"]]})
        return json.dumps(said)


def perform(job: str, program: str, beat: Callable[[float], None]) -> str:
    """Do one job, given as JSON, with the program; the result as JSON.

    `beat(t)` hears now and then the simulated time that a run has come to [s]: nothing here can
    end a program that computes for ever, so the page does if it no longer hears time pass.
    """
    due = 0.0

    def on_flush() -> None:
        nonlocal due
        if real_time() >= due:
            due = real_time() + BEAT_SECONDS  # first: clock() is a call that flushes
            beat(clock())

    return json.dumps(do(json.loads(job), program, on_flush))
