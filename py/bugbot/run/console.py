"""What stands in for the screen and the keyboard while a program runs.

May import: the standard library, `bugbot.errors`, `bugbot.trace`, `bugbot.run.limits`.
"""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any, NoReturn

from bugbot.errors import NoInputError, WrongTypeError, got
from bugbot.run.limits import Meter
from bugbot.trace import Trace, storable

__all__ = ["NoKeyboard", "Print", "Screen", "no_debugger", "no_input"]

_NO_INPUT = (
    "a program can't ask for typed input while the robot runs: put the value in the program, "
    "for example name = 'Ada'"
)
_NO_DEBUGGER = "print() what you want to know, or step through the run afterwards"


def no_input(*_prompt: object) -> NoReturn:
    """What input() is during a run."""
    raise NoInputError(f"input() has nobody to answer it: {_NO_INPUT}")


def no_debugger(*_arguments: object) -> NoReturn:
    """What breakpoint() is during a run."""
    raise NoInputError(f"breakpoint() has nobody to answer it: {_NO_DEBUGGER}")


class NoKeyboard(io.TextIOBase):
    """sys.stdin during a run: reading from it is refused as input() is."""

    def readable(self) -> bool:
        """It may be asked; it will not answer."""
        return True

    def read(self, size: int | None = -1, /) -> NoReturn:
        """Refuse."""
        raise NoInputError(f"sys.stdin has nobody to answer it: {_NO_INPUT}")

    def readline(self, size: int | None = -1, /) -> NoReturn:
        """Refuse."""
        self.read()

    __next__ = readline  # for line in sys.stdin

    def close(self) -> None:
        """Stay open: Python's own exit() closes sys.stdin first."""


Print = Callable[[float, str, str], None]
"""Is told of printed text: the simulated time [s], the stream, the text."""


def _both(first: Print, second: Print) -> Print:
    def write(t: float, stream: str, text: str) -> None:
        first(t, stream, text)
        second(t, stream, text)

    return write


class Screen(io.TextIOBase):
    """sys.stdout or sys.stderr during a run: everything written becomes print events."""

    encoding = "utf-8"
    errors = "replace"

    def __init__(
        self,
        stream: str,
        trace: Trace,
        now: Callable[[], float],
        meter: Meter,
        on_print: Print | None = None,
    ) -> None:
        self.name = stream
        self._write = trace.write if on_print is None else _both(trace.write, on_print)
        self._now = now
        self._meter = meter

    def writable(self) -> bool:
        """It can be written to."""
        return True

    def write(self, text: Any, /) -> int:
        """Record the text at the present simulated time; ends the run past the limit."""
        if not isinstance(text, str):
            raise WrongTypeError(f"sys.{self.name}.write(text) wants a text; it got {got(text)}")
        text = storable(text)
        meter, length = self._meter, len(text)
        if length > meter.print_left:
            kept, meter.print_left = text[: meter.print_left], 0
            self._write(self._now(), self.name, kept)
            meter.check()  # a limit reached before this one counts, not this
            meter.too_much_printed()
        if length:
            meter.print_left -= length
            self._write(self._now(), self.name, text)
        meter.check()
        return length
