"""The error as the slips look at it.

May import: the standard library, `bugbot.api`.
"""

from __future__ import annotations

import builtins
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from bugbot import api

__all__ = ["CALLS", "Case", "Slip", "bare_calls", "lines_of"]

CALLS = tuple(name for name in api.__all__ if name not in ("Robot", "go"))
"""The robot's calls."""


@dataclass(frozen=True, slots=True)
class Case:
    """An error in a learner's program.

    error    the exception
    message  its own text
    line     the learner's line, 1 first, or None
    lines    the whole program
    scope    the names in sight on that line, and their values; empty if it never ran
    filename the program's
    """

    error: BaseException
    message: str
    line: int | None
    lines: list[str]
    scope: Mapping[str, object]
    filename: str

    @property
    def text(self) -> str:
        """The learner's line."""
        return "" if self.line is None else self.text_of(self.line)

    def text_of(self, line: int) -> str:
        """The text of a line, empty beyond the end."""
        return self.lines[line - 1] if 0 < line <= len(self.lines) else ""

    @property
    def code(self) -> str:
        """The learner's line without its comment and with every text in quotes emptied."""
        plain = re.sub(r"\"[^\"]*\"|'[^']*'", '""', self.text)
        return plain.partition("#")[0]


def lines_of(source: str) -> list[str]:
    """The lines of a program as Python counts them, without their ends."""
    return source.replace("\r\n", "\n").replace("\r", "\n").split("\n")


Slip = Callable[[Case], str | None]


def bare_calls(case: Case) -> list[str]:
    """The functions that the line names without brackets, in order."""
    found = re.findall(r"(?<![\w.])([A-Za-z_]\w*)\b(?!\s*(?:[(.]|=(?!=)))", case.code)
    return [name for name in found if _is_function(case.scope.get(name, vars(builtins).get(name)))]


def _is_function(value: object) -> bool:
    return callable(value) and not isinstance(value, type)
