"""A program with other constants: changed in its text, before it runs.

May import: the standard library.

Whatever the program works out from a constant while it starts follows: HALF = CELL / 2, a default
size=CELL. No line moves, so messages name the learner's own lines.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from typing import Any

__all__ = ["unwritten", "with_constants"]


_ROW = ast.Tuple | ast.List


def with_constants(program: str, constants: Mapping[str, Any]) -> str:
    r"""The program with each `NAME = …` at its top level given another value.

    >>> with_constants("CELL = 10; HALF = CELL / 2", {"CELL": 4})
    'CELL = (4); HALF = CELL / 2'
    """
    program = program.removeprefix("\ufeff")  # what some editors put before the text
    try:
        tree = ast.parse(program)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return program
    lines = program.encode().splitlines(keepends=True)
    starts = [0]
    for line in lines:
        starts.append(starts[-1] + len(line))
    text = program.encode()
    places = [
        (starts[value.lineno - 1] + value.col_offset, value, constants[name])
        for name, value in _assigned(tree.body)
        if name in constants
    ]
    for start, value, new in sorted(places, key=lambda place: -place[0]):
        assert value.end_lineno is not None
        assert value.end_col_offset is not None
        end = starts[value.end_lineno - 1] + value.end_col_offset
        breaks = "\n" * (value.end_lineno - value.lineno)
        text = text[:start] + f"({new!r}{breaks})".encode() + text[end:]
    return text.decode()


def unwritten(program: str, constants: Mapping[str, Any]) -> dict[str, Any]:
    """Those of the constants that have no value in the text that could be changed."""
    try:
        tree = ast.parse(program.removeprefix("\ufeff"))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return {}
    written = {name for name, _ in _assigned(tree.body)}
    return {name: value for name, value in constants.items() if name not in written}


def _assigned(statements: list[ast.stmt]) -> Iterator[tuple[str, ast.expr]]:
    """The names given a value outside functions and loops, with the expression of the value."""
    for node in statements:
        if isinstance(node, ast.If | ast.Try | ast.With):
            for part in ("body", "orelse", "finalbody"):
                yield from _assigned(getattr(node, part, []))
        if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name) and node.value:
            yield node.target.id, node.value
        if not isinstance(node, ast.Assign):
            continue
        for target in node.targets:
            if isinstance(target, ast.Name):
                yield target.id, node.value
            elif isinstance(target, _ROW) and isinstance(node.value, _ROW):
                for each, value in zip(target.elts, node.value.elts, strict=False):
                    if isinstance(each, ast.Name):
                        yield each.id, value
