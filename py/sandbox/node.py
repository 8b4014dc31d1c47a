"""Does a job in the locked-down Python under Node: for files that nobody vouches for.

May import: the standard library, the rest of `sandbox`.

Each job has a process of its own (site/sandbox/performer.ts): the page's own worker, with Node's
permission model around it, behind the walls that the system has (`walls.py`). Under Linux the
process is also told, before it hears of the program, that it can open nothing more and start
nothing: no file, no socket, no pipe, no thread. It is ended from here when it takes too long,
tells of no simulated time passing, or says too much.
"""

from __future__ import annotations

import json
import os
import subprocess
import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path
from queue import Empty, Queue
from time import monotonic
from types import TracebackType
from typing import IO, Any

from sandbox.processes import computed_s, end
from sandbox.walls import Walls, innermost, walls_for

__all__ = ["NoSandboxError", "Sandbox", "SandboxError", "close_everything", "prepared"]

_ROOT = Path(__file__).resolve().parents[2]
_PREPARE = _ROOT / "site" / "build" / "sandbox.mjs"

_START_S = 120.0
"""A machine that takes longer to start an interpreter has a trouble of its own [s]."""

_WAITS = 10
"""A process that has its part of the processor is done after so many times its limit."""

_LOOK_S = 0.05
"""How soon to look again at what a process has computed [s]."""

_MOST_BYTES = 100_000_000
"""A longer answer is no answer."""

_DATA_BYTES = 4_000_000_000
"""Memory of the whole process; Python in it may have 1 GB."""

_SYSTEM = ("SYSTEMROOT",)
"""What Node needs of the environment, on Windows. The rest, passwords among it, stays here."""


class NoSandboxError(Exception):
    """There is no sandbox on this machine; the message says what is missing."""


class SandboxError(Exception):
    """The sandbox itself failed: a fault of ours or of this machine, never the learner's."""


@dataclass(frozen=True, slots=True)
class _Prepared:
    command: tuple[str, ...]
    folder: str
    walls: Walls


@cache
def prepared() -> _Prepared:
    """Have the sandbox made, if it is not; raises NoSandboxError saying what is missing."""
    advice = "install Node 20.19 or newer and run `npm install` in the project's folder, "
    advice += "or go without it by --trusted if you trust every file"
    if not _PREPARE.exists():
        raise NoSandboxError(f"the sandbox is made by {_PREPARE}, which is not there: {advice}")
    try:
        done = subprocess.run(
            ["node", str(_PREPARE)], cwd=_ROOT, stdout=subprocess.PIPE, text=True, check=False
        )
    except OSError as error:
        raise NoSandboxError(f"Node can't be started ({error.strerror}): {advice}") from None
    if done.returncode != 0:
        raise NoSandboxError(f"the sandbox could not be prepared (see above): {advice}")
    said = json.loads(done.stdout.splitlines()[-1])
    command, folder = tuple(said["command"]), said["folder"]
    return _Prepared(command, folder, walls_for(command[0], folder))


class Sandbox:
    """Does jobs one after the other, as `Performer` does. Use it in a `with` block."""

    def __init__(self) -> None:
        self._prepared = prepared()
        self._process: subprocess.Popen[bytes] | None = None

    def __enter__(self) -> Sandbox:
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
        process, lines = self._start()
        try:
            _expect(lines, b"ready")
            inner = innermost(process.pid)
            close_everything(inner, job["limits"]["real_s"])
            assert process.stdin is not None
            with suppress(BrokenPipeError):  # it has died: its last line says so
                process.stdin.write(json.dumps({"job": job, "program": program}).encode())
                process.stdin.close()
            _expect(lines, b"begun")
            return _answer(job, lines, partial(computed_s, inner))
        finally:
            self.close()

    def close(self) -> None:
        """End the process that is at work, if one is."""
        process, self._process = self._process, None
        if process is not None:
            end(process)

    def _start(self) -> tuple[subprocess.Popen[bytes], Queue[bytes]]:
        process = subprocess.Popen(
            self._prepared.walls.round(self._prepared.command),
            cwd=self._prepared.folder,
            env={name: os.environ[name] for name in _SYSTEM if name in os.environ},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        self._process = process
        lines: Queue[bytes] = Queue()
        assert process.stdout is not None
        threading.Thread(target=_read, args=(process.stdout, lines), daemon=True).start()
        return process, lines


def _read(pipe: IO[bytes], lines: Queue[bytes]) -> None:
    """Hand on each line that comes; an empty one when nothing more will, or one is too long."""
    try:
        while True:
            line = pipe.readline(_MOST_BYTES)
            lines.put(line.removesuffix(b"\n") if line.endswith(b"\n") else b"")
            if not line.endswith(b"\n"):
                return
    except (OSError, ValueError):  # closed meanwhile
        lines.put(b"")


def _expect(lines: Queue[bytes], word: bytes) -> None:
    """Wait for a line of the start, before any of the program has run."""
    try:
        line = lines.get(timeout=_START_S)
    except Empty:
        raise SandboxError(f"the locked-down Python did not start in {_START_S:g} s") from None
    if line != word:
        raise SandboxError(f"the locked-down Python did not start: {_words(line)}")


def _answer(
    job: dict[str, Any], lines: Queue[bytes], spent_s: Callable[[], float]
) -> dict[str, Any]:
    """What comes of the job; only the time that it computes counts against its limits."""
    limits = job["limits"]
    # Calls end their own endless loops, and tell nothing of simulated time.
    silent_s = limits["real_s"] if job["kind"] == "calls" else limits["silent_s"]
    began = spent_s()
    gone = monotonic() + _WAITS * limits["real_s"]
    late, silent = began + limits["real_s"], began + silent_s
    reached = 0.0
    while True:
        try:
            line = lines.get(timeout=max(_LOOK_S, min(late, silent) - spent_s()))
        except Empty:
            if spent_s() >= min(late, silent) or monotonic() >= gone:
                return _died(job, "time")
            continue
        word, _, rest = line.partition(b" ")
        if word == b"beat":
            if float(rest) > reached:
                reached = float(rest)
                silent = spent_s() + silent_s
        elif word == b"result":
            return _result(job, rest)
        elif word == b"failed":
            raise SandboxError(_words(rest))
        else:
            return _died(job, "crash")


def _result(job: dict[str, Any], text: bytes) -> dict[str, Any]:
    try:
        result = json.loads(text)
    except (ValueError, RecursionError):
        return _died(job, "crash")
    if not isinstance(result, dict) or result.get("id") != job["id"]:
        return _died(job, "crash")
    return result


def _died(job: dict[str, Any], how: str) -> dict[str, Any]:
    return {"id": job["id"], "trace": None, "outcome": None, "answers": None, "died": how}


def _words(line: bytes) -> str:
    return line.decode("utf-8", "replace")[:2000] or "it ended without a word"


def close_everything(pid: int, real_s: float) -> None:
    """From now on the process opens nothing, writes no file and starts nothing; on Linux alone."""
    try:
        from resource import (
            RLIMIT_CPU,
            RLIMIT_DATA,
            RLIMIT_FSIZE,
            RLIMIT_NOFILE,
            RLIMIT_NPROC,
            prlimit,
        )
    except ImportError:
        return
    seconds = int(real_s) + 60  # should nobody be left to end it; threads count each
    limits = {
        RLIMIT_NOFILE: 0,
        RLIMIT_FSIZE: 0,
        RLIMIT_NPROC: 0,
        RLIMIT_DATA: _DATA_BYTES,
        RLIMIT_CPU: seconds,
    }
    with suppress(OSError):  # some containers refuse; the other fences stand
        for limit, most in limits.items():
            prlimit(pid, limit, (most, most))
