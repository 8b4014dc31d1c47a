"""What a program has printed and the page has not been sent, kept in JavaScript's memory.

When Python's stack overflows, nothing of Python can be called any more; so no print may be only
here. In a flood each call of JavaScript counts: a newline waits for the next text.
"""

from __future__ import annotations

from collections.abc import Callable

__all__ = ["Kept"]


class Kept:
    """Tells of each print: `begin(t, stream)` where that is new, then `keep(text)`."""

    def __init__(self, begin: Callable[[float, str], None], keep: Callable[[str], None]) -> None:
        self._begin = begin
        self._keep = keep
        self._place: tuple[float, str] | None = None
        self._newline = ""

    def add(self, t: float, stream: str, text: str) -> None:
        """Something has been printed at this simulated time [s]."""
        if (t, stream) != self._place:
            self._keep_newline()
            self._place = (t, stream)
            self._begin(t, stream)
        if text == "\n" and not self._newline:
            self._newline = text
        else:
            self._keep(self._newline + text)
            self._newline = ""

    def _keep_newline(self) -> None:
        if self._newline:
            self._keep(self._newline)
            self._newline = ""

    def sent(self) -> None:
        """The page has everything that was printed so far."""
        self._newline = ""
