"""The dialogue of judge and performer under plain CPython.

May import: the standard library, `grader.judge`, `grader.processes`.

A `Performer` keeps one process waiting that has imported what a run needs, and nothing of a
judge. For each job it forks, so that every job has a fresh interpreter a few milliseconds
after it is asked for; where there is no fork (Windows), the process does one job and is started
again. A job that takes too long, answers too much or breaks its interpreter is ended from here.
"""

from __future__ import annotations

import json
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from queue import Empty, Queue
from types import TracebackType
from typing import IO, Any

from grader.judge import step
from grader.processes import end

__all__ = ["Performer", "mark_program"]

_PY = Path(__file__).parents[1]
_MOST_BYTES = 200_000_000
"""A longer answer is no answer."""

_SERVE = "import sys; sys.path.insert(0, sys.argv[1]); from grader.serving import serve; serve()"

Perform = Callable[[dict[str, Any], str], dict[str, Any]]


def mark_program(
    check_source: str,
    lesson: dict[str, Any],
    task: str,
    program: str,
    perform_job: Perform,
    *,
    shift: int = 0,
) -> dict[str, Any]:
    """The mark of a program; `perform_job(job, program)` does each job."""
    results: list[dict[str, Any]] = []
    while True:
        done = step(check_source, lesson, task, program, results, shift=shift)
        if "mark" in done:
            mark: dict[str, Any] = done["mark"]
            return mark
        results += [perform_job(job, program) for job in done["jobs"]]


class Performer:
    """Does jobs one after the other, each in a fresh interpreter. Use it in a `with` block."""

    def __init__(self) -> None:
        self._server: subprocess.Popen[bytes] | None = None
        self._lines: Queue[bytes] = Queue()

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
        request = json.dumps({"job": job, "program": program}) + "\n"
        assert server.stdin is not None
        try:
            server.stdin.write(request.encode())
            server.stdin.flush()
            line = self._lines.get(timeout=job["limits"]["real_s"])
        except Empty:
            self.close()
            return _died(job, "time")
        except OSError:
            self.close()
            return _died(job, "crash")
        try:
            result = json.loads(line)
        except (ValueError, RecursionError):
            self.close()
            return _died(job, "crash")
        if not isinstance(result, dict) or result.get("id") != job["id"]:
            return _died(job, "crash")
        return result

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
            [sys.executable, "-c", _SERVE, str(_PY)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        assert server.stdout is not None
        threading.Thread(target=_read, args=(server.stdout, self._lines), daemon=True).start()
        self._server = server
        return server


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
