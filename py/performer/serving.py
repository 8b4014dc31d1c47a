"""The performer's process under plain CPython: does the jobs that come in, a line each.

May import: the standard library, `performer.perform`. It has never imported a judge.
"""

from __future__ import annotations

import json
import os
import signal
import sys
from math import ceil
from typing import Any

from performer.perform import perform

__all__ = ["serve"]

_MOST_MEMORY = 3_000_000_000
"""Bytes that one job may have."""


def serve() -> None:
    """Do the jobs that come in, a line each, until there are no more."""
    out = os.dup(1)
    os.dup2(2, 1)  # what a program writes past its own screen goes nowhere
    for line in sys.stdin:
        request = json.loads(line)
        if not hasattr(os, "fork"):
            _do(request, out)
            return
        child = os.fork()
        if child == 0:
            _limit(request["job"]["limits"]["real_s"])
            _do(request, out)
            os._exit(0)
        status = os.waitpid(child, 0)[1]
        # Told whether or not it has answered.
        _write(out, {"over": request["turn"], "died": "time" if _ran_out(status) else "crash"})


def _do(request: dict[str, Any], out: int) -> None:
    end_process = os._exit  # during a run the name belongs to the program
    try:
        result = perform(request["job"], request["program"])
        _write(out, result)
    except BaseException:
        sys.excepthook(*sys.exc_info())
        end_process(1)


def _write(out: int, result: dict[str, Any]) -> None:
    rest = json.dumps(result).encode() + b"\n"
    while rest:
        rest = rest[os.write(out, rest) :]


def _limit(seconds: float) -> None:
    """Of memory, and of the processor's time: what others keep the job waiting does not count."""
    try:
        import resource
    except ImportError:
        return
    resource.setrlimit(resource.RLIMIT_AS, (_MOST_MEMORY, _MOST_MEMORY))
    whole = max(1, ceil(seconds))
    resource.setrlimit(resource.RLIMIT_CPU, (whole, whole + 1))


def _ran_out(status: int) -> bool:
    """Whether the system has ended a process because its time of the processor was over."""
    return os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGXCPU
