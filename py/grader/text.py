"""What stands in a learner's program: so that it contradicts no cause that is told.

May import: the standard library.

A condition is made by one of the words below and handed to `mistake(…, where=…)` in a check.py:

    calls("int", "round")   one of these is called, as int(…) or as math.floor(…)
    reads("L_MAX")          one of these names is read
    operator("<", "//")     one of these is used: + - * / // % ** < <= > >= == != and or not in
    number(8)               one of these numbers is typed in
    lacks(condition)        it is not so
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator

__all__ = ["Condition", "Text", "calls", "lacks", "number", "operator", "reads"]

_SIGNS: dict[type[ast.AST], str] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.FloorDiv: "//",
    ast.Mod: "%",
    ast.Pow: "**",
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Eq: "==",
    ast.NotEq: "!=",
    ast.And: "and",
    ast.Or: "or",
    ast.Not: "not",
    ast.In: "in",
}

_Functions = ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda


class Text:
    """A program, or one function of it with all that it calls, as it is written."""

    def __init__(self, program: str, function: str | None = None) -> None:
        self._parts: list[ast.AST] = []
        self.function: _Functions | None = None
        """The function itself, if the program defines it in so many words."""
        try:
            tree = ast.parse(program.removeprefix("\ufeff"))
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            return
        defined = _defined(tree)
        self.function = defined.get(function or "")
        self._parts = [tree] if self.function is None else list(_reached(self.function, defined))

    def _nodes(self) -> Iterator[ast.AST]:
        for part in self._parts:
            yield from ast.walk(part)

    def called(self) -> set[str]:
        """The names of all that is called; of math.floor(…) the last."""
        return {_called(node) for node in self._nodes() if isinstance(node, ast.Call)}

    def names(self) -> set[str]:
        """The names that are read."""
        nodes = self._nodes()
        return {n.id for n in nodes if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Load)}

    def signs(self) -> set[str]:
        """The operators that are used."""
        return {_SIGNS[type(node)] for node in self._nodes() if type(node) in _SIGNS}

    def numbers(self) -> set[float]:
        """The numbers that are typed in."""
        constants = (node.value for node in self._nodes() if isinstance(node, ast.Constant))
        return {each for each in constants if isinstance(each, int | float)}

    @property
    def returns_a_value(self) -> bool:
        """Whether the function has a `return` with something after it; True if nobody can say."""
        if self.function is None or isinstance(self.function, ast.Lambda):
            return True
        own = _own_nodes(self.function)
        return any(isinstance(node, ast.Return) and node.value is not None for node in own)


Condition = Callable[[Text], bool]


def calls(*names: str) -> Condition:
    """One of these is called."""
    return lambda text: not text.called().isdisjoint(names)


def reads(*names: str) -> Condition:
    """One of these names is read."""
    return lambda text: not text.names().isdisjoint(names)


def operator(*signs: str) -> Condition:
    """One of these operators is used."""
    return lambda text: not text.signs().isdisjoint(signs)


def number(*values: float) -> Condition:
    """One of these numbers is typed in."""
    return lambda text: not text.numbers().isdisjoint(values)


def lacks(condition: Condition) -> Condition:
    """The condition does not hold."""
    return lambda text: not condition(text)


def _called(node: ast.Call) -> str:
    function = node.func
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


def _defined(tree: ast.Module) -> dict[str, _Functions]:
    found: dict[str, _Functions] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            found[node.name] = node
        elif isinstance(node, ast.Assign) and isinstance(node.value, ast.Lambda):
            found.update(
                {each.id: node.value for each in node.targets if isinstance(each, ast.Name)}
            )
    return found


def _reached(start: _Functions, defined: dict[str, _Functions]) -> Iterator[ast.AST]:
    """The function and every function of the program whose name stands in it, and so on."""
    seen: set[int] = set()
    waiting: list[_Functions] = [start]
    while waiting:
        node = waiting.pop()
        if id(node) in seen:
            continue
        seen.add(id(node))
        yield node
        names = {each.id for each in ast.walk(node) if isinstance(each, ast.Name)}
        names |= {each.attr for each in ast.walk(node) if isinstance(each, ast.Attribute)}
        waiting += [defined[name] for name in names if name in defined]


def _own_nodes(function: ast.FunctionDef | ast.AsyncFunctionDef) -> Iterator[ast.AST]:
    """The nodes of a function, without those of functions inside it."""
    waiting: list[ast.AST] = list(function.body)
    while waiting:
        node = waiting.pop()
        yield node
        if not isinstance(node, _Functions | ast.ClassDef):
            waiting += ast.iter_child_nodes(node)
