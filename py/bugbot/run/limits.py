"""How long, how much and how far a run may go, and what ends it.

May import: the standard library, `bugbot.trace`, `bugbot.run.standstill`.

`Limits` are the figures. `Meter` counts against them and raises `LimitReached`,
which is no `Exception`, so `except Exception` does not swallow it. A program that
does swallow it, with a bare `except`, meets it again in its next call and on its
next line.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType
from typing import Any, NoReturn

from bugbot.run.standstill import Standstill
from bugbot.trace import Trace

__all__ = ["LimitReached", "Limits", "Meter"]


@dataclass(frozen=True, slots=True)
class Limits:
    """What one run may use up."""

    simulated_s: float = 600.0
    """Simulated seconds."""
    silent_s: float = 60.0
    """Real seconds of computing without any simulated time passing."""
    print_bytes: int = 2_000_000
    """Characters printed."""
    trace_bytes: int = 64_000_000
    """Rough size of the trace."""


_RECORDED = {
    "scan": ("readings of the depth sensor", "Put wait(0.1) into the loop that takes them."),
    "print": ("printed text", "Print less often."),
    "layer": ("drawing", "Draw less often, or fewer points."),
    "rest": ("plots, lights and movement", "Put a longer wait() into the loop."),
}
"""What may have filled a trace -> in words, and what to do."""


class LimitReached(BaseException):
    """The run has used up a limit; the text goes on after "Stopped "."""


class Meter:
    """Counts what a run uses; the `Guard` of its link."""

    def __init__(
        self,
        limits: Limits,
        trace: Trace,
        filename: str,
        on_flush: Callable[[], None] | None = None,
    ) -> None:
        self.limits = limits
        self.over: LimitReached | None = None
        self.line: int | None = None
        """The learner's line on which the limit was reached."""
        self._trace = trace
        self._filename = filename
        self._on_flush = on_flush
        self._still = Standstill(trace.header["program"], filename)
        self._now = 0.0
        self.print_left = limits.print_bytes
        """Characters that may still be printed."""

    def check(self) -> None:
        """Raise if the run is over; else give the page its turn."""
        if self.over is not None:
            self._insist(self.over)
        if self._trace.bytes > self.limits.trace_bytes:
            self._too_much_recorded()
        endless = self._still.called(sys._getframe(1))
        if endless is not None:
            self._end_still(endless)
        self.flush()

    def flush(self) -> None:
        """Give the page what has been recorded so far, if it wants it now."""
        if self._on_flush is not None:
            self._on_flush()

    def time_passed(self, now: float) -> None:
        """Simulated time has come to this moment [s]."""
        self._now = now
        self._still.time_passed()

    def looked(self) -> None:
        """Raise if the depth sensor is used again and again and no time passes."""
        endless = self._still.looked(sys._getframe(1))
        if endless is not None:
            self._end_still(endless)

    def allow(self, now: float, seconds: float) -> float:
        """How many of these seconds may still pass [s]."""
        return min(seconds, self.limits.simulated_s - now)

    def time_is_up(self) -> NoReturn:
        """End the run: it wanted more simulated time than there is."""
        self._end(
            f"after {self.limits.simulated_s:g} simulated seconds: one run may last no longer. "
            "A loop that should end on its own needs a condition, or break."
        )

    @contextmanager
    def set_aside(self) -> Iterator[None]:
        """Inside this block a limit that is reached does not count, unless it is reached again."""
        over, line = self.over, self.line
        self.over = self.line = None
        try:
            yield
        finally:
            if self.over is None:
                self.over, self.line = over, line

    def silence(self, frame: FrameType | None) -> None:
        """The run is over: it computes, in this frame, and no time passes. The watchdog raises."""
        self.line = self.line_of(frame)
        self.over = LimitReached(
            f"after {self.limits.silent_s:g} s of computing in which no simulated time passed. "
            "If a loop waits for the robot there, put wait(0.1) into it."
        )

    def too_much_printed(self) -> NoReturn:
        """End the run: it has printed all it may."""
        self._end(
            f"after printing {self.limits.print_bytes / 1e6:g} MB: one run may print no more. "
            "Is there a print() in a loop that never waits? Put wait(0.1) into the loop."
        )

    def _too_much_recorded(self) -> NoReturn:
        parts = self._trace.bytes_of
        rest = self._trace.bytes - sum(parts.values())
        kind, most = max(parts.items(), key=lambda part: part[1])
        what, advice = _RECORDED[kind if most >= rest else "rest"]
        self._end(
            f"after recording {self.limits.trace_bytes / 1e6:g} MB, most of it {what}: one run may "
            f"record no more. {advice}"
        )

    def _end_still(self, words: str) -> NoReturn:
        self._end(words.format(now=f"{self._now:g}"))

    def _end(self, words: str) -> NoReturn:
        self.line = self.line_of(sys._getframe(1))
        self.over = LimitReached(words)
        raise self.over

    def line_of(self, frame: FrameType | None) -> int | None:
        """The program's line that this frame is on, or one that called it; None outside it."""
        while frame is not None and frame.f_code.co_filename != self._filename:
            frame = frame.f_back
        return None if frame is None else frame.f_lineno

    def _insist(self, limit: LimitReached) -> NoReturn:
        """Raise a limit that the program has swallowed, and once more on the line it goes on with.

        `while True: try: … except: pass` catches what is raised in the `try`. What a trace
        function raises on the line of the handler itself is outside it.
        """

        def raise_again(frame: FrameType, event: str, _: Any) -> Any:
            if event == "line" and frame.f_code.co_filename == self._filename:
                raise limit.with_traceback(None)
            return raise_again

        sys.settrace(raise_again)
        frame: FrameType | None = sys._getframe(1)
        while frame is not None:
            if frame.f_code.co_filename == self._filename:
                frame.f_trace = raise_again
            frame = frame.f_back
        raise limit.with_traceback(None)
