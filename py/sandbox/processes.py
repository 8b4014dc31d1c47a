"""Ending a process that was started with pipes and in a session of its own.

May import: the standard library.
"""

from __future__ import annotations

import os
import signal
import subprocess
from contextlib import suppress

__all__ = ["end"]


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
