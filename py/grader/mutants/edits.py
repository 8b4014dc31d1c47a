"""A program as its text and its tree, and changes to a piece of the text.

May import: the standard library.

Changes are made to the text, not to the tree: so a mutant keeps its lines and looks as a
learner would have written it.
"""

from __future__ import annotations

import ast
from dataclasses import dataclass

__all__ = ["Edit", "Source", "Span"]

Span = tuple[int, int]
"""From one byte of the program's UTF-8 text up to another."""


@dataclass(frozen=True, slots=True)
class Edit:
    """One change: its kind, where, and what stands there afterwards."""

    kind: str
    span: Span
    text: str


class Source:
    """A program that can be cut into by the nodes of its tree."""

    def __init__(self, program: str) -> None:
        self.program = program
        self.data = program.encode("utf-8")
        self.tree = ast.parse(program)
        self._callers = {
            argument: node
            for node in ast.walk(self.tree)
            if isinstance(node, ast.Call)
            for argument in node.args
        }
        self._starts = [0]
        for line in self.data.split(b"\n"):
            self._starts.append(self._starts[-1] + len(line) + 1)

    def given_to(self, node: ast.expr) -> str:
        """The name of the function whose argument this is; "" if it is none's."""
        caller = self._callers.get(node)
        function = None if caller is None else caller.func
        return function.id if isinstance(function, ast.Name) else getattr(function, "attr", "")

    def at(self, line: int, column: int) -> int:
        """The byte at a line (1 is the first) and a column in bytes."""
        return self._starts[line - 1] + column

    def line_of(self, byte: int) -> int:
        """The line that a byte is on."""
        return self.data.count(b"\n", 0, byte) + 1

    def span(self, node: ast.expr | ast.stmt) -> Span:
        """Where a node stands."""
        assert node.end_lineno is not None
        assert node.end_col_offset is not None
        return self.at(node.lineno, node.col_offset), self.at(node.end_lineno, node.end_col_offset)

    def lines(self, node: ast.stmt) -> Span:
        """The complete lines of a statement, with the decorators above it."""
        assert node.end_lineno is not None
        first = min([node.lineno, *(each.lineno for each in getattr(node, "decorator_list", []))])
        return self._starts[first - 1], min(self._starts[node.end_lineno], len(self.data))

    def text(self, where: Span | ast.expr | ast.stmt) -> str:
        """What stands there."""
        start, end = where if isinstance(where, tuple) else self.span(where)
        return self.data[start:end].decode("utf-8")

    def bracketed(self, node: ast.expr) -> str:
        """An expression as it may stand inside any other."""
        text = self.text(node)
        simple = ast.Name | ast.Constant | ast.Call | ast.Attribute | ast.Subscript | ast.List
        if isinstance(node, simple) and "\n" not in text:
            return text
        return f"({text})"

    def between(self, left: ast.expr, right: ast.expr, sign: str) -> Span:
        """Where the operator between two expressions stands; comments are passed over."""
        start, end = self.span(left)[1], self.span(right)[0]
        gap = self.data[start:end]
        place = start
        for line in gap.split(b"\n"):
            found = line.split(b"#")[0].find(sign.encode())
            if found >= 0:
                return place + found, place + found + len(sign)
            place += len(line) + 1
        raise ValueError(f"no {sign} between {self.text(left)} and {self.text(right)}")

    def changed(self, edit: Edit) -> str:
        """The program with one change made."""
        start, end = edit.span
        return (self.data[:start] + edit.text.encode() + self.data[end:]).decode("utf-8")
