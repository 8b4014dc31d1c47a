"""One name for another of its kind, and a number for a name.

May import: the standard library, `grader.mutants.edits`.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from grader.mutants.edits import Edit, Source

__all__ = ["Scope", "available", "edits_of"]

_PAIRS = (
    ("x", "y"),
    ("column", "row"),
    ("columns", "rows"),
    ("dx", "dy"),
    ("angle", "heading"),
    ("free", "occupied"),
    ("hits", "passes"),
    ("left", "right"),
    ("width", "height"),
)
_WORD = re.compile(r"[A-Za-z]+|\d+")


class Scope:
    """The names that a piece of the program can use: parameters, its own, and the program's."""

    def __init__(self, tree: ast.Module, function: ast.AST | None) -> None:
        self.constants = dict(_constants(tree))
        self.parameters: list[str] = []
        if isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            arguments = function.args
            self.parameters = [each.arg for each in [*arguments.posonlyargs, *arguments.args]]
        stored = _stored(function if function is not None else tree)
        self.names = {*stored, *self.parameters, *self.constants}

    def instead(self, name: str) -> Iterator[str]:
        """The names that somebody may have written in place of this one, likeliest first."""
        given: dict[str, None] = {}
        for one, other in _PAIRS:
            given |= dict.fromkeys([_with(name, one, other), _with(name, other, one)])
        if name in self.parameters:
            given |= dict.fromkeys(self.parameters)
        if name in self.constants:
            given |= dict.fromkeys(each for each in self.constants if each.isupper())
        yield from (each for each in given if each != name and each in self.names)


def available(tree: ast.Module) -> frozenset[str]:
    """Functions by the names by which the program can call them, as floor or math.floor."""
    names = {"int", "round", "min", "max", "abs", "any", "all"}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            names |= {each.asname or each.name for each in node.names}
        elif isinstance(node, ast.Import) and any(each.name == "math" for each in node.names):
            known = ("floor", "ceil", "sin", "cos", "radians", "degrees")
            names |= {f"math.{each}" for each in known}
    names |= {"append", "extend", "add", "update"}
    return frozenset(names)


def edits_of(source: Source, node: ast.AST, scope: Scope) -> Iterator[Edit]:
    """The changes at one node."""
    if not isinstance(node, ast.Name):
        return
    for other in scope.instead(node.id):
        yield Edit("other name", source.span(node), other)
    if isinstance(node.ctx, ast.Load) and node.id in scope.constants:
        yield Edit("number for a name", source.span(node), repr(scope.constants[node.id]))


def _with(name: str, one: str, other: str) -> str:
    """The name with one of its words changed: goal_x to goal_y."""
    return _WORD.sub(lambda found: other if found[0] == one else found[0], name)


def _constants(tree: ast.Module) -> Iterator[tuple[str, float]]:
    """The numbers that have a name in capitals at the top of the program."""
    for node in tree.body:
        if not isinstance(node, ast.Assign):
            continue
        target, value = node.targets[0], node.value
        pairs = [(target, value)]
        if isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple):
            pairs = list(zip(target.elts, value.elts, strict=False))
        for each, worth in pairs:
            if isinstance(each, ast.Name) and each.id.isupper():
                try:
                    number = ast.literal_eval(worth)
                except ValueError:
                    continue
                if isinstance(number, int | float):
                    yield each.id, number


def _stored(node: ast.AST) -> set[str]:
    return {
        each.id
        for each in ast.walk(node)
        if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store)
    }
