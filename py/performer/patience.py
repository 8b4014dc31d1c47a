"""Ends what a program computes for too long, at next to no cost to one that does not.

May import: the standard library, `performer.limits`.

A timer has Python look at the clock now and then: the system's own under CPython, and in a browser
the presses of Ctrl-C that the worker pretends (`bugbot.run.watchdog`). Only when the time is over
is the program followed line by line, and ended on one of its own lines: what is in the middle of
our code or of a module being imported is left to finish. Where there is no such timer, on Windows
and in other threads, the lines are followed from the beginning.

A browser has no clock of the processor, so waiting for it counts as well there. A program that gets
through few lines once its time is over has longer: it is in no loop of its own.
"""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Callable
from time import process_time as cpu_time  # a run puts simulated time in the module's place
from types import CodeType, FrameType
from typing import Any

from performer.limits import FEW_LINES_A_S, SLOW

__all__ = ["Patience", "TooLate"]

_AGAIN_S = 0.05
"""How soon the timer comes again once the time is over: a program may have caught what ended it."""

_LOOK_EVERY = 16
"""Of the lines that are followed, so many go by between two looks at the clock."""

_TOOLS = (3, 4)
"""Numbers that `sys.monitoring` leaves to anybody."""

_IN_A_BROWSER = sys.platform == "emscripten"


class TooLate(BaseException):
    """A program has computed for longer than it may; no Exception, so few programs catch it."""


class Patience:
    """Does a program's work, and ends it when its time is over. Use it in a `with` block."""

    def __init__(self, filename: str) -> None:
        self.late_on: int | None = None
        """The line of the program on which work was ended."""
        self._filename = filename
        self._seconds: float | None = None
        """What the work may take; None while there is none."""
        self._began = 0.0
        self._lines = 0
        """How many of its lines the program was followed through."""
        self._over = False
        """Whether even a program that gets through few lines has had its time."""
        self._ended = False
        """Whether the work was ended; a program may catch that."""
        self._first: FrameType | None = None
        """The frame of the program's function that the work began with."""
        self._before: Any = None
        """Who looked on before: a debugger, a measure of coverage, or nobody."""
        self._outside: Any = None
        """The same, before all of it."""
        self._number: signal.Signals | None = None
        self._handler: Any = None
        self._tool: int | None = None
        in_main = threading.current_thread() is threading.main_thread()
        if in_main and (_IN_A_BROWSER or hasattr(signal, "setitimer")):
            self._number = signal.SIGINT if _IN_A_BROWSER else signal.SIGPROF

    def __enter__(self) -> Patience:
        self._outside = sys.gettrace()
        monitoring = getattr(sys, "monitoring", None)  # since Python 3.12
        if monitoring is not None and self._number is not None:
            self._tool = next((each for each in _TOOLS if monitoring.get_tool(each) is None), None)
            if self._tool is not None:
                monitoring.use_tool_id(self._tool, "patience")
                monitoring.register_callback(self._tool, monitoring.events.PY_START, self._on_start)
                monitoring.set_events(self._tool, monitoring.events.PY_START)
        return self

    def __exit__(self, *_error: object) -> None:
        self.end()
        sys.settrace(self._outside)  # a run has put back whom it found
        if self._tool is not None:
            monitoring: Any = vars(sys)["monitoring"]
            monitoring.set_events(self._tool, 0)
            monitoring.register_callback(self._tool, monitoring.events.PY_START, None)
            monitoring.free_tool_id(self._tool)
            self._tool = None

    def have(self, work: Callable[[], Any], seconds: float) -> Any:
        """Do some work; raises TooLate if the program computes for more seconds than that."""
        self._before, self._first = sys.gettrace(), None
        self._lines, self._over, self._ended = 0, False, False
        if self._number is not None:
            self._handler = signal.signal(self._number, self._tick)
        self._began, self._seconds = cpu_time(), seconds
        if self._number is not None and not _IN_A_BROWSER:
            signal.setitimer(signal.ITIMER_PROF, seconds, _AGAIN_S)
        if self._tool is None:
            sys.settrace(self._on_first)
        try:
            return work()
        finally:
            self.end()

    def end(self) -> None:
        """Stop watching the time: what comes now is not the program's. May be called twice."""
        if self._seconds is None:
            return
        self._seconds = None
        sys.settrace(self._before)
        if self._number is not None:
            if not _IN_A_BROWSER:
                signal.setitimer(signal.ITIMER_PROF, 0.0)
            signal.signal(self._number, self._handler)

    def left_on(self) -> int | None:
        """The line on which the function that the work began with returned. Ask once only."""
        first, self._first = self._first, None
        return None if first is None else first.f_lineno

    def look(self) -> None:
        """Look at the clock: called from our own code while the program runs."""
        self._look(sys._getframe(1))

    # -- what Python tells ---------------------------------------------------

    def _on_start(self, code: CodeType, _offset: int) -> Any:
        if code.co_filename != self._filename:
            return vars(sys)["monitoring"].DISABLE
        if self._first is None:
            self._first = sys._getframe(1)
        return None

    def _on_first(self, frame: FrameType, event: str, argument: Any) -> Any:
        if frame.f_code.co_filename != self._filename:
            return None
        # While we hold its frame, it tells even after the return which line it returned from.
        self._first = frame
        if self._number is not None:
            sys.settrace(self._before)
            return None
        sys.settrace(self._on_line)
        return self._on_line(frame, event, argument)

    def _tick(self, number: int, frame: FrameType | None) -> None:
        if _IN_A_BROWSER and callable(self._handler):
            self._handler(number, frame)  # the watchdog looks at its own clock
        self._look(frame)
        if self._ended and frame is not None and frame.f_code.co_filename == self._filename:
            raise TooLate  # it has caught the first one: again, outside its `try`

    def _look(self, frame: FrameType | None) -> None:
        """Follow the program from here if its time is over."""
        if self._seconds is None:
            return
        taken = cpu_time() - self._began
        if taken <= self._seconds:
            return
        self._over = taken > SLOW * self._seconds
        if sys.gettrace() == self._on_line:
            return
        sys.settrace(self._on_line)
        while frame is not None:
            if frame.f_code.co_filename == self._filename:
                frame.f_trace = self._on_line
            frame = frame.f_back

    def _on_line(self, frame: FrameType, event: str, _argument: Any) -> Any:
        if frame.f_code.co_filename != self._filename:
            return None
        if event != "line":
            return self._on_line
        self._lines += 1
        if self._seconds is not None and self._is_late():
            self._ended = True
            self.late_on = frame.f_lineno
            raise TooLate
        return self._on_line

    def _is_late(self) -> bool:
        if self._ended or self._over:
            return True
        return self._lines % _LOOK_EVERY == 0 and self._has_had_its_time()

    def _has_had_its_time(self) -> bool:
        assert self._seconds is not None
        taken = cpu_time() - self._began
        if taken <= self._seconds:
            return False
        return self._lines > FEW_LINES_A_S * self._seconds or taken > SLOW * self._seconds
