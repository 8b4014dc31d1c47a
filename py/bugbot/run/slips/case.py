"""The error as the slips look at it.

May import: the standard library, `bugbot.api`.
"""

from __future__ import annotations

import ast
import builtins
import re
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from bugbot import api

__all__ = ["CALLS", "Case", "Slip", "bare_calls", "lines_of"]

_LONGEST_LINE = 2000
"""Characters of a line that patterns are tried on: some take the square of its length."""

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
        """The text of a line, empty beyond the end; of a very long one, its beginning."""
        return self.lines[line - 1][:_LONGEST_LINE] if 0 < line <= len(self.lines) else ""

    @property
    def code(self) -> str:
        """The learner's line without its comment and with every text in quotes emptied."""
        return _code(self.text)

    def lines_with(self, word: str, quoted: bool = False) -> list[int]:
        """The lines on which a name stands, or a text in quotes."""
        pattern = f"(['\"]){re.escape(word)}\\1" if quoted else rf"(?<!\w){re.escape(word)}(?!\w)"
        return [
            number
            for number, text in enumerate(self.lines, 1)
            if word in text and re.search(pattern, text if quoted else _code(text))
        ]

    @property
    def raised_on_it(self) -> bool:
        """Whether the error came up on the line itself and not in a function of somebody else's."""
        step = self.error.__traceback__
        while step is not None and step.tb_next is not None:
            step = step.tb_next
        return step is not None and step.tb_frame.f_code.co_filename == self.filename

    def is_read(self, text: str) -> bool:
        """Whether the program can be read with this text for the learner's line."""
        if self.line is None:
            return False
        lines = [*self.lines[: self.line - 1], text, *self.lines[self.line :]]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                compile("\n".join(lines), self.filename, "exec", dont_inherit=True)
            except (SyntaxError, ValueError, RecursionError, MemoryError):
                return False
        return True

    def parts(self, *kinds: type[ast.AST]) -> list[Any]:
        """The parts of the program of these kinds that reach over the learner's line."""
        if self.line is None or isinstance(self.error, SyntaxError):
            return []
        with warnings.catch_warnings():  # they have been shown when the program was compiled
            warnings.simplefilter("ignore")
            try:
                tree = ast.parse("\n".join(self.lines))
            except (SyntaxError, ValueError, RecursionError, MemoryError):
                return []
        nodes: list[Any] = [each for each in ast.walk(tree) if isinstance(each, kinds)]
        return [each for each in nodes if each.lineno <= self.line <= each.end_lineno]


def _code(text: str) -> str:
    plain = re.sub(r"\"[^\"]*\"|'[^']*'", '""', text)
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
