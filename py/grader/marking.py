"""The dialogue of judge and performer under plain CPython.

May import: the standard library, `grader.judge`, `sandbox.processes`.

A `Performer` keeps one process waiting that has imported what a run needs, and can't import a
judge. For each job it forks, so that every job has a fresh interpreter a few milliseconds
after it is asked for; where there is no fork (Windows), the process does one job and is started
again. A job that takes too long, answers too much or breaks its interpreter is ended from here.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from queue import Empty, Queue
from time import monotonic
from types import TracebackType
from typing import IO, Any

from grader.judge import first_failure, step
from sandbox.processes import end

__all__ = ["Performer", "mark_program"]

_PY = Path(__file__).parents[1]
_MOST_BYTES = 200_000_000
"""A longer answer is no answer."""

_WAITS = 10 if hasattr(os, "fork") else 1
"""Where there is a fork, a job's own process counts its time of the processor. It is also ended
after so many times its limit by the clock on the wall; elsewhere there is that clock alone."""

_SERVE = """
import sys
from importlib.util import module_from_spec, spec_from_file_location
for name in ("bugbot", "performer"):
    folder = f"{sys.argv[1]}/{name}"
    spec = spec_from_file_location(
        name, f"{folder}/__init__.py", submodule_search_locations=[folder]
    )
    sys.modules[name] = module_from_spec(spec)
    spec.loader.exec_module(sys.modules[name])
from performer.serving import serve
serve()
"""
"""These two packages and no more: where they lie is not on the path, so neither the judge nor the
reference can be imported there."""

Perform = Callable[[dict[str, Any], str], dict[str, Any]]


def mark_program(
    check_source: str,
    lesson: dict[str, Any],
    task: str,
    program: str,
    perform_job: Perform,
    *,
    shift: int = 0,
    until_failed: bool = False,
) -> dict[str, Any]:
    """The mark of a program; `perform_job(job, program)` does each job.

    until_failed  the checks after the first that fails need not be run
    """
    results: list[dict[str, Any]] = []
    while True:
        done = step(check_source, lesson, task, program, results, shift=shift)
        if "mark" in done:
            mark: dict[str, Any] = done["mark"]
            return mark
        for job in sorted(done["jobs"], key=lambda job: bool(job["kind"] == "run")):
            results.append(perform_job(job, program))
            if until_failed and len(done["jobs"]) > 1:
                failed = first_failure(check_source, lesson, task, program, results, shift=shift)
                if failed is not None:
                    return failed


class Performer:
    """Does jobs one after the other, each in a fresh interpreter. Use it in a `with` block."""

    def __init__(self) -> None:
        self._server: subprocess.Popen[bytes] | None = None
        self._lines: Queue[bytes] = Queue()
        self._turn = 0

    def __enter__(self) -> Performer:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def perform(self, job: dict[str, Any], program: str) -> dict[str, Any]:
        """Do a job; whatever happens to its interpreter is in the result."""
        server = self._started()
        self._turn += 1
        request = json.dumps({"job": job, "program": program, "turn": self._turn}) + "\n"
        assert server.stdin is not None
        try:
            server.stdin.write(request.encode())
            server.stdin.flush()
            return self._answer(job, monotonic() + _WAITS * job["limits"]["real_s"])
        except Empty:
            self.close()
            return _died(job, "time")
        except OSError:
            self.close()
            return _died(job, "crash")

    def _answer(self, job: dict[str, Any], late: float) -> dict[str, Any]:
        """What comes back for this job; what an earlier program left in the pipe is passed over."""
        while True:
            line = self._lines.get(timeout=max(0.0, late - monotonic()))
            try:
                result = json.loads(line)
            except (ValueError, RecursionError):
                self.close()
                return _died(job, "crash")
            if not isinstance(result, dict):
                continue
            if result.get("id") == job["id"]:
                return result
            if result.get("over") == self._turn:
                return _died(job, "time" if result.get("died") == "time" else "crash")

    def close(self) -> None:
        """End the process and whatever it has started."""
        server, self._server = self._server, None
        if server is not None:
            end(server)

    def _started(self) -> subprocess.Popen[bytes]:
        if self._server is not None and self._server.poll() is None:
            return self._server
        self.close()
        self._lines = Queue()
        server = subprocess.Popen(
            [sys.executable, "-s", "-P", "-c", _SERVE, str(_PY)],
            env=_environment(),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        assert server.stdout is not None
        threading.Thread(target=_read, args=(server.stdout, self._lines), daemon=True).start()
        self._server = server
        return server


def _environment() -> dict[str, str]:
    """Without a path to our packages; with the order of sets that the page's Python has as well."""
    kept = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    return {**kept, "PYTHONHASHSEED": "0"}


def _died(job: dict[str, Any], how: str) -> dict[str, Any]:
    return {"id": job["id"], "trace": None, "outcome": None, "answers": None, "died": how}


def _read(pipe: IO[bytes], lines: Queue[bytes]) -> None:
    """Hand on each line that comes; an empty one when nothing more will, or one is too long."""
    try:
        while True:
            line = pipe.readline(_MOST_BYTES)
            lines.put(line if line.endswith(b"\n") else b"")
            if not line.endswith(b"\n"):
                return
    except (OSError, ValueError):  # closed meanwhile
        lines.put(b"")
