"""Threads during a run: there are none, and nothing is waited for that only one could bring.

May import: the standard library, `bugbot.errors`.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, NoReturn

from bugbot.errors import NoThreadError, StuckError

__all__ = ["no_threads"]


@contextmanager
def no_threads(sleep: Callable[[Any], None]) -> Iterator[None]:
    """Inside this block no thread starts, and a wait with a time limit is a `sleep`."""
    start, wait = threading.Thread.start, threading.Condition.wait
    program = threading.get_ident()

    def wait_alone(self: threading.Condition, timeout: float | None = None) -> bool:
        """Condition.wait(), which Event.wait() and queue.get() use: nobody is there to notify."""
        if threading.get_ident() != program:
            return wait(self, timeout)
        if timeout is None:
            raise StuckError(
                "the program waits for something that can't come: there are no other threads"
            )
        sleep(max(0.0, timeout))
        return False

    threading.Thread.start = _no_thread  # type: ignore[assignment,method-assign]
    threading.Condition.wait = wait_alone  # type: ignore[method-assign]
    try:
        yield
    finally:
        threading.Thread.start = start  # type: ignore[method-assign]
        threading.Condition.wait = wait  # type: ignore[method-assign]


def _no_thread(_thread: threading.Thread) -> NoReturn:
    """Thread.start() during a run: the same everywhere, for a browser has no threads."""
    raise NoThreadError(
        "a program can't start threads: the robot's programs do one thing after another"
    )
