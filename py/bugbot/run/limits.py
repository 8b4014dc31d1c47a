"""How long, how much and how far a run may go, and what ends it.

May import: the standard library, `bugbot.trace`.

`Limits` are the figures. `Meter` counts against them and raises `LimitReached`,
which is no `Exception`, so `except Exception` does not swallow it; a program that
does swallow it, with a bare `except`, gets it again in its next call.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

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


class LimitReached(BaseException):
    """The run has used up a limit; the text says which, in words for the learner."""


class Meter:
    """Counts what a run uses; the `Guard` of its link."""

    def __init__(
        self, limits: Limits, trace: Trace, on_flush: Callable[[], None] | None = None
    ) -> None:
        self.over: LimitReached | None = None
        self._limits = limits
        self._trace = trace
        self._on_flush = on_flush
        self._printed = 0

    def check(self) -> None:
        """Raise if the run is over; else give the page its turn."""
        if self.over is not None:
            raise self.over
        if self._trace.bytes > self._limits.trace_bytes:
            self._end(
                f"after recording {self._limits.trace_bytes / 1e6:g} MB of drawing, scans and "
                "movement: one run may record no more. Draw less often, or fewer points"
            )
        if self._on_flush is not None:
            self._on_flush()

    def allow(self, now: float, seconds: float) -> float:
        """How many of these seconds may still pass [s]."""
        return min(seconds, self._limits.simulated_s - now)

    def time_is_up(self) -> None:
        """End the run: it wanted more simulated time than there is."""
        self._end(
            f"after {self._limits.simulated_s:g} simulated seconds: one run may last no longer. "
            "A loop that should end on its own needs a condition, or break"
        )

    def silence(self) -> LimitReached:
        """The end of a run that computes without simulated time passing; the watchdog raises it."""
        self.over = LimitReached(
            f"after {self._limits.silent_s:g} s of computing in which no simulated time passed: "
            "a loop needs a wait(), or it never lets the robot move"
        )
        return self.over

    def printing(self, text: str) -> str:
        """What may still be printed of this text; raises through `check` when that is not all."""
        left = self._limits.print_bytes - self._printed
        self._printed += len(text)
        return text if len(text) <= left else text[: max(0, left)]

    def check_printing(self) -> None:
        """End the run if it has printed too much."""
        if self._printed > self._limits.print_bytes:
            self._end(
                f"after printing {self._limits.print_bytes / 1e6:g} MB: one run may print no more. "
                "Is there a print() in a loop that never waits?"
            )
        self.check()

    def _end(self, words: str) -> None:
        self.over = LimitReached(words)
        raise self.over
