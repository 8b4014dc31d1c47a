"""Ends a program that computes for ever, where that can be done from inside.

May import: the standard library, `bugbot.run.limits`.

Under plain CPython a thread watches the simulated clock and, when it has stood
still for too long, interrupts the program again and again until it gives in. In a
browser there are no threads: the worker pretends that Ctrl-C is pressed a few times a second,
which gives Python a moment to look at the clock, and the page ends the worker.
"""

from __future__ import annotations

import signal
import sys
import threading
from _thread import interrupt_main
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic
from types import FrameType

from bugbot.run.limits import Meter

__all__ = ["STILL_S", "Still", "watched"]

Still = Callable[[int], None]
"""Is told, once a standstill, on which line of the program no simulated time passes."""

STILL_S = 1.5
"""So long may a program compute before it is told that no simulated time passes [s]."""

_LOOK_EVERY_S = 0.25
_INTERRUPT_EVERY_S = 0.02
_GRACE_S = 2.0
"""How long a program may resist before it is given up [s]."""


@contextmanager
def watched(
    meter: Meter,
    now: Callable[[], float],
    filename: str,
    give_up: Callable[[], None] | None,
    on_still: Still | None = None,
) -> Iterator[None]:
    """Inside this block, silence longer than the limit is ended.

    `give_up` is called from the watching thread if the program can't be interrupted (a
    calculation inside C that never returns).
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    clock = _Clock(meter, now, on_still)
    if sys.platform == "emscripten":
        with _looking(clock, meter, filename):
            yield
        return

    def on_interrupt(_signal: int, frame: FrameType | None) -> None:
        if meter.over is None:
            raise KeyboardInterrupt  # Ctrl-C
        # Only the program is interrupted, never our own tidying up after it.
        while frame is not None:
            if frame.f_code.co_filename == filename:
                raise meter.over.with_traceback(None)
            frame = frame.f_back

    done = threading.Event()
    thread = threading.Thread(target=_watch, args=(meter, clock, done, give_up), daemon=True)
    before = signal.signal(signal.SIGINT, on_interrupt)
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()
        signal.signal(signal.SIGINT, before)


class _Clock:
    """How long simulated time has stood still, in real time; tells of it once."""

    def __init__(self, meter: Meter, now: Callable[[], float], on_still: Still | None) -> None:
        self._meter = meter
        self._now = now
        self._on_still = on_still
        self._seen, self._since, self._told = now(), monotonic(), False

    def still_s(self, find: Callable[[], FrameType | None]) -> float:
        """How long [s], 0 if time has passed since last asked; `find` gives what computes."""
        if self._now() != self._seen:
            self._seen, self._since, self._told = self._now(), monotonic(), False
            return 0.0
        still = monotonic() - self._since
        if still >= STILL_S and not self._told and self._on_still is not None:
            frame = find()
            line = None if _is_loading(frame) else self._meter.line_of(frame)
            if line is not None:
                self._told = True
                self._on_still(line)
        return still


def _is_loading(frame: FrameType | None) -> bool:
    """Whether a module is being imported: NumPy takes a while, and no loop of the program's."""
    while frame is not None:
        if frame.f_code.co_filename.startswith("<frozen importlib"):
            return True
        frame = frame.f_back
    return False


@contextmanager
def _looking(clock: _Clock, meter: Meter, filename: str) -> Iterator[None]:
    """Inside this block each Ctrl-C is a look at the clock, and no more."""

    def look(_signal: int, frame: FrameType | None) -> None:
        clock.still_s(lambda: frame)
        # In the middle of our own code something may be half written.
        if frame is not None and frame.f_code.co_filename == filename:
            meter.flush()

    before = signal.signal(signal.SIGINT, look)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _watch(
    meter: Meter,
    clock: _Clock,
    done: threading.Event,
    give_up: Callable[[], None] | None,
) -> None:
    def computing() -> FrameType | None:
        return sys._current_frames().get(threading.main_thread().ident or 0)

    while not done.wait(min(_LOOK_EVERY_S, meter.limits.silent_s / 4)):
        still = clock.still_s(computing)
        if still > meter.limits.silent_s or (still > 0 and meter.over is not None):
            break
    else:
        return
    if meter.over is None:
        meter.silence(computing())
    interrupted = monotonic()
    while monotonic() - interrupted < _GRACE_S:
        interrupt_main()
        if done.wait(_INTERRUPT_EVERY_S):
            return
    if give_up is not None:
        give_up()
