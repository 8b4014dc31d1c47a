"""Simulated time for programs that use Python's own `time` module.

May import: the standard library, `bugbot.errors`.

During a run `time.sleep()` lets simulated time pass, and `time.time()`,
`monotonic()`, `perf_counter()` and their `_ns` sisters read it, so a program
written with them runs unchanged and gives the same result every time.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

__all__ = ["EPOCH_S", "simulated_time"]

EPOCH_S = 1_767_225_600.0
"""What time.time() says when a run begins: the first moment of 2026, UTC. Always the same."""


@contextmanager
def simulated_time(now: Callable[[], float], sleep: Callable[[Any], None]) -> Iterator[None]:
    """Inside this block the `time` module follows `now` (seconds since the start) and `sleep`."""

    def since_epoch() -> float:
        return EPOCH_S + now()

    def in_ns(clock: Callable[[], float]) -> Callable[[], int]:
        return lambda: round(clock() * 1e9)

    replaced: dict[str, Callable[..., Any]] = {
        "sleep": sleep,
        "time": since_epoch,
        "time_ns": in_ns(since_epoch),
        "monotonic": now,
        "monotonic_ns": in_ns(now),
        "perf_counter": now,
        "perf_counter_ns": in_ns(now),
    }
    before = {name: getattr(time, name) for name in replaced}
    try:
        for name, function in replaced.items():
            setattr(time, name, function)
        yield
    finally:
        for name, function in before.items():
            setattr(time, name, function)
