"""Ends a program that computes for ever, where that can be done from inside.

May import: the standard library, `bugbot.run.limits`.

Under plain CPython a thread watches the simulated clock and, when it has stood
still for too long, interrupts the program again and again until it gives in. In a
browser there are no threads and no signals: the page watches, and ends the worker.
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

__all__ = ["watched"]

_LOOK_EVERY_S = 0.25
_INTERRUPT_EVERY_S = 0.02
_GRACE_S = 2.0
"""How long a program may resist before it is given up [s]."""


@contextmanager
def watched(
    meter: Meter, now: Callable[[], float], filename: str, give_up: Callable[[], None] | None
) -> Iterator[None]:
    """Inside this block, silence longer than the limit is ended.

    `give_up` is called from the watching thread if the program can't be interrupted (a
    calculation inside C that never returns).
    """
    if sys.platform == "emscripten" or threading.current_thread() is not threading.main_thread():
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
    thread = threading.Thread(target=_watch, args=(meter, now, done, give_up), daemon=True)
    before = signal.signal(signal.SIGINT, on_interrupt)
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()
        signal.signal(signal.SIGINT, before)


def _watch(
    meter: Meter,
    now: Callable[[], float],
    done: threading.Event,
    give_up: Callable[[], None] | None,
) -> None:
    seen, since = now(), monotonic()
    while not done.wait(min(_LOOK_EVERY_S, meter.limits.silent_s / 4)):
        if now() != seen:
            seen, since = now(), monotonic()
        elif meter.over is not None or monotonic() - since > meter.limits.silent_s:
            break
    else:
        return
    if meter.over is None:
        meter.silence(sys._current_frames().get(threading.main_thread().ident or 0))
    interrupted = monotonic()
    while monotonic() - interrupted < _GRACE_S:
        interrupt_main()
        if done.wait(_INTERRUPT_EVERY_S):
            return
    if give_up is not None:
        give_up()
