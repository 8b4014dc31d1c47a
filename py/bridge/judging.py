"""The judge's side of a marking in the browser. The page carries the texts between it and the
performers, each in a worker of its own; this module and `grader` come to the judge's worker alone.
"""

from __future__ import annotations

import json
from typing import Any

from grader.judge import step

__all__ = ["Judge"]


class Judge:
    """The judge's side of one marking; this interpreter never runs any of the program.

    request  JSON: lesson (its slug), task (its name), check (the text of check.py),
             program, starter (what the learner began with), worlds (the lesson's own)
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
        starters = {request["task"]: request["starter"]}
        lesson = {"slug": request["lesson"], "worlds": worlds, "starters": starters}
        said = step(request["check"], lesson, request["task"], request["program"], self._results)
        if "jobs" in said:
            return json.dumps({"jobs": [json.dumps(job) for job in said["jobs"]]})
        return json.dumps(said)
