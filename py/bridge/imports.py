"""Which modules a program asks for, so that they are there before it runs."""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator

__all__ = ["missing_modules"]

_PLAIN_IMPORT = re.compile(
    r"[ \t]*(?:from[ \t]+([\w.]+)[ \t]+import[ \t]+[\w*, \t]+"
    r"|import[ \t]+([\w.]+)(?:[ \t]+as[ \t]+\w+)?[ \t]*)(?:#.*)?"
)
"""A line with one import as most programs have it. No two repetitions stand side by side that
could share the same spaces: a long line would take the square of its length."""


def missing_modules(program: str) -> list[str]:
    """Top-level names of the modules that a program imports and that are not loaded yet.

    A program that cannot be parsed has none: running it will say what is wrong.
    """
    if _plainly_has_all(program):
        return []
    try:
        tree = ast.parse(program)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return []
    names: dict[str, None] = {}
    for node in _statements(tree):
        if isinstance(node, ast.Import):
            imported = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            imported = [node.module or ""]
        else:
            continue
        for name in imported:
            # Of a dotted name, the package may be loaded and the module not.
            if name and name not in sys.modules:
                names[name.partition(".")[0]] = None
    return list(names)


def _plainly_has_all(program: str) -> bool:
    """Whether one sees without parsing, which takes some ms, that all it imports is loaded."""
    lines = program.splitlines()
    if any(line.endswith("\\") for line in lines):  # an import may go on in the next line
        return False
    found = [_PLAIN_IMPORT.fullmatch(line) for line in lines if "import" in line]
    return all(one is not None and (one[1] or one[2]) in sys.modules for one in found)


def _statements(tree: ast.AST) -> Iterator[ast.AST]:
    """Every statement, however deep. Expressions, which are most of a tree, are left out."""
    waiting = [tree]
    while waiting:
        each = waiting.pop()
        yield each
        for name in ("body", "orelse", "finalbody", "handlers", "cases"):
            inner = getattr(each, name, None)
            if isinstance(inner, list):  # a lambda's body is none
                waiting += inner
