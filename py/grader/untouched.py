"""Whether a learner has written anything yet.

May import: the standard library, `grader.parts`.

What counts is the code, not how it is laid out: a comment, an empty line or a `pass` is nothing
written. Where the starter marks the learner's part, that part alone is looked at: a constant that
has been changed at the top of the program is nothing written either.
"""

from __future__ import annotations

import ast
from textwrap import dedent

from grader.parts import PartError, lines_of_part

__all__ = ["NOTHING_WRITTEN", "is_untouched"]

NOTHING_WRITTEN = "nothing is written yet: your part of the program is still as it was at first"
"""The cause that is told of such a program, whatever it looks like."""


def is_untouched(program: str, starter: str) -> bool:
    """Whether the program has no more code than the starter that it was made from."""
    if not starter:
        return False
    try:
        parts = [_part_of(starter, each) for each in (starter, program)]
    except PartError:
        return False
    if not all(parts):  # no part is marked, or nobody can say which it is
        parts = [starter, program]
    before, now = map(_code, parts)
    return before is not None and before == now


def _part_of(starter: str, program: str) -> str:
    lines = program.splitlines()
    return dedent("\n".join(lines[number - 1] for number in lines_of_part(starter, program)))


def _code(text: str) -> list[str] | None:
    """What the text does, statement by statement; None if it is no Python."""
    try:
        tree = _Written().visit(ast.parse(text.removeprefix("\ufeff")))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    return [ast.dump(each) for each in tree.body]


class _Written(ast.NodeTransformer):
    """Leaves out what does nothing: `pass`, and texts and numbers on a line of their own."""

    def visit_Pass(self, node: ast.Pass) -> None:
        return None

    def visit_Expr(self, node: ast.Expr) -> ast.Expr | None:
        return None if isinstance(node.value, ast.Constant) else node
