"""Processes that were started with pipes and in a session of their own: their time, and their end.

May import: the standard library.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from time import monotonic

__all__ = ["computed_s", "end"]


def end(process: subprocess.Popen[bytes]) -> None:
    """End the process with whatever it has started, and close its pipes."""
    with suppress(ProcessLookupError):  # it may be gone by itself
        if hasattr(os, "killpg"):
            os.killpg(process.pid, signal.SIGKILL)
        else:
            process.kill()
    process.wait()
    for pipe in (process.stdin, process.stdout):
        if pipe is not None:
            with suppress(BrokenPipeError):  # what was still to be written went nowhere
                pipe.close()


def computed_s(pid: int) -> float:
    """How long a process has computed [s]; by the clock where the system does not say."""
    if not sys.platform.startswith("linux"):
        return monotonic()
    try:
        # Its first thread alone: the others compile and tidy up beside it.
        stat = Path(f"/proc/{pid}/task/{pid}/stat").read_text("utf-8", "replace")
    except OSError:
        return 0.0  # it has ended, as its pipe is about to tell
    user, system = stat.rpartition(")")[2].split()[11:13]
    return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")
