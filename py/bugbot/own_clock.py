"""Simulated time for programs that use Python's own `time` module.

May import: the standard library.

During a run every clock of `time` reads simulated time and `time.sleep()` lets it pass, so
a program written with them runs unchanged and gives the same result every time. The zone
is UTC, whatever the machine's is. `bugbot.run.dates` does the same for `datetime`.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

__all__ = ["EPOCH_S", "simulated_time"]

EPOCH_S = 1_767_225_600.0
"""What time.time() says when a run begins: the first moment of 2026, UTC. Always the same."""

_gmtime, _asctime, _strftime = time.gmtime, time.asctime, time.strftime
_SINCE_START = ("monotonic", "perf_counter", "process_time", "thread_time")
"""Clocks that begin with the run. Computing takes no simulated time, so all four agree."""


@contextmanager
def simulated_time(now: Callable[[], float], sleep: Callable[[Any], None]) -> Iterator[None]:
    """Inside this block the `time` module follows `now` (seconds since the start) and `sleep`."""
    replaced = {
        name: value for name, value in _replacements(now, sleep).items() if hasattr(time, name)
    }
    before = {name: getattr(time, name) for name in replaced}
    try:
        vars(time).update(replaced)
        yield
    finally:
        vars(time).update(before)


def _replacements(now: Callable[[], float], sleep: Callable[[Any], None]) -> dict[str, Any]:
    def since_epoch() -> float:
        return EPOCH_S + now()

    def gmtime(seconds: float | None = None, /) -> time.struct_time:
        return _gmtime(since_epoch() if seconds is None else seconds)

    def asctime(moment: Any = None, /) -> str:
        return _asctime(gmtime() if moment is None else moment)

    def ctime(seconds: float | None = None, /) -> str:
        return _asctime(gmtime(seconds))

    def strftime(form: str, moment: Any = None, /) -> str:
        return _strftime(form, gmtime() if moment is None else moment)

    def mktime(moment: Any, /) -> float:
        from calendar import timegm  # rarely wanted, and it brings datetime with it

        return float(timegm(moment))

    def clock_gettime(clock: int, /) -> float:
        return since_epoch() if clock == time.CLOCK_REALTIME else now()

    clocks: dict[str, Callable[..., float]] = {
        "time": since_epoch,
        "clock_gettime": clock_gettime,
        **dict.fromkeys(_SINCE_START, now),
    }
    return {
        **clocks,
        **{f"{name}_ns": _in_ns(clock) for name, clock in clocks.items()},
        "sleep": sleep,
        "gmtime": gmtime,
        "localtime": gmtime,
        "asctime": asctime,
        "ctime": ctime,
        "strftime": strftime,
        "mktime": mktime,
        "timezone": 0,
        "altzone": 0,
        "daylight": 0,
        "tzname": ("UTC", "UTC"),
    }


def _in_ns(clock: Callable[..., float]) -> Callable[..., int]:
    return lambda *which: round(clock(*which) * 1e9)
