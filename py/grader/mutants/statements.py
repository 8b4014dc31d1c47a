"""Mistakes with whole statements: left out, in the wrong order, a guard that is not there.

May import: the standard library, `grader.mutants.edits`.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from itertools import pairwise

from grader.mutants.edits import Edit, Source

__all__ = ["blocks_of", "edits_of"]

_STAYS = (
    *(ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Import, ast.ImportFrom),
    *(ast.Pass, ast.Global, ast.Nonlocal),
)
_SIMPLE = (ast.Expr, ast.Assign, ast.AugAssign, ast.AnnAssign)
_COMPOUND = (ast.If, ast.For, ast.While)


def blocks_of(node: ast.AST) -> Iterator[list[ast.stmt]]:
    """The lists of statements right under a node."""
    for name in ("body", "orelse", "finalbody"):
        block = getattr(node, name, None)
        if isinstance(block, list) and block and isinstance(block[0], ast.stmt):
            yield block


def edits_of(source: Source, node: ast.AST) -> Iterator[Edit]:
    """The changes at a statement, or in the order of those under a node."""
    for block in blocks_of(node):
        yield from _order(source, block)
    if not isinstance(node, ast.stmt) or isinstance(node, _STAYS) or _is_docstring(node):
        return
    yield Edit("statement left out", source.span(node), "pass")
    if isinstance(node, ast.If):
        span = source.span(node.test)
        yield Edit("guard", span, "True")
        yield Edit("negation", span, f"not ({source.text(node.test)})")
        if node.orelse:
            yield Edit("guard", span, "False")
    elif isinstance(node, ast.For | ast.While):
        yield from _early(source, node)
    elif isinstance(node, ast.Break):
        yield Edit("break/continue", source.span(node), "continue")
    elif isinstance(node, ast.Continue):
        yield Edit("break/continue", source.span(node), "break")
    elif isinstance(node, ast.AugAssign):
        target = source.text(node.target)
        yield Edit("not added", source.span(node), f"{target} = {source.text(node.value)}")
        sign = {ast.Add: ("+=", "-="), ast.Sub: ("-=", "+=")}.get(type(node.op))
        if sign is not None:
            yield Edit("arithmetic", source.between(node.target, node.value, sign[0]), sign[1])


def _is_docstring(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)


def _order(source: Source, block: list[ast.stmt]) -> Iterator[Edit]:
    """Two statements one after the other, swapped."""
    for one, other in pairwise(block):
        simple = sum(isinstance(each, _SIMPLE) for each in (one, other))
        compound = sum(isinstance(each, _COMPOUND) for each in (one, other))
        if simple >= 1 and simple + compound == 2 and not _is_docstring(one):
            span = (source.span(one)[0], source.span(other)[1])
            gap = source.text((source.span(one)[1], source.span(other)[0]))
            if "\n" in gap and _depend(one, other):
                yield Edit("order", span, f"{source.text(other)}{gap}{source.text(one)}")


def _depend(one: ast.stmt, other: ast.stmt) -> bool:
    """Can it matter which of two statements comes first?"""
    if not (isinstance(one, ast.Assign) and isinstance(other, ast.Assign)):
        return True
    written, read = _names(one, ast.Store), _names(one, ast.Load)
    written_2, read_2 = _names(other, ast.Store), _names(other, ast.Load)
    plain = all(_is_names(each) for each in [*one.targets, *other.targets])
    return not plain or bool(written & (read_2 | written_2) or written_2 & read)


def _is_names(target: ast.expr) -> bool:
    parts = target.elts if isinstance(target, ast.Tuple) else [target]
    return all(isinstance(each, ast.Name) for each in parts)


def _names(node: ast.AST, used: type[ast.expr_context]) -> set[str]:
    walked = ast.walk(node)
    return {each.id for each in walked if isinstance(each, ast.Name) and isinstance(each.ctx, used)}


def _early(source: Source, loop: ast.For | ast.While) -> Iterator[Edit]:
    """The loop ends after its first round, as with a return one level too deep."""
    last = loop.body[-1]
    if isinstance(last, ast.Break | ast.Return):
        return
    end = source.span(last)[1]
    indent = " " * loop.body[0].col_offset
    if loop.body[0].lineno != loop.lineno:
        yield Edit("early return", (end, end), f"\n{indent}break")
