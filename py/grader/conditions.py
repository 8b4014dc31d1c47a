"""What must stand in a learner's program for a cause to be told.

May import: the standard library, `grader.failures`, `grader.text`.

A condition is made by one of the words below and handed to `mistake(…, where=…)` in a check.py:

    calls("int", "round")    one of these is called or handed on, as int(…) or math.floor(…)
    reads("L_MAX")           one of these names is read
    stores("x")              one of these names is given a value
    operator("<", "//")      one of these is used: + - * / // % ** ^ & | < <= > >= == != and or not in
    number(8)                one of these numbers is typed in
    code("p / 1 - p")        such a piece of code stands there, `_` standing for any value
    loops()                  there is a for, a while or a comprehension
    lacks(condition)         it is not so
    either(one, another)     one of them is so
"""  # noqa: E501 - a table

from __future__ import annotations

import ast
from collections.abc import Callable
from typing import Any

from grader.failures import AuthorError
from grader.text import Text

__all__ = [
    "Condition",
    "calls",
    "code",
    "either",
    "lacks",
    "loops",
    "number",
    "operator",
    "reads",
    "stores",
]

Condition = Callable[[Text], bool]


def calls(*names: str) -> Condition:
    """One of these is called."""
    return lambda text: not text.called.isdisjoint(names)


def reads(*names: str) -> Condition:
    """One of these names is read."""
    return lambda text: not text.names.isdisjoint(names)


def stores(*names: str) -> Condition:
    """One of these names is given a value."""
    return lambda text: not text.stored.isdisjoint(names)


def operator(*signs: str) -> Condition:
    """One of these operators is used."""
    return lambda text: not text.signs.isdisjoint(signs)


def number(*values: float) -> Condition:
    """One of these numbers is typed in."""
    return lambda text: not text.numbers.isdisjoint(values)


def loops() -> Condition:
    """There is a loop: a for, a while or a comprehension."""
    kinds = (ast.For, ast.While, ast.comprehension)
    return lambda text: any(isinstance(each, kinds) for each in text.nodes)


def lacks(condition: Condition) -> Condition:
    """The condition does not hold."""
    return lambda text: not condition(text)


def either(*conditions: Condition) -> Condition:
    """One of the conditions holds."""
    return lambda text: any(each(text) for each in conditions)


def code(*pieces: str) -> Condition:
    """One of these pieces of code stands there; `_` stands for any value."""
    patterns = [_pattern(each) for each in pieces]
    return lambda text: any(_fits(each, node) for node in text.nodes for each in patterns)


def _pattern(piece: str) -> ast.AST:
    try:
        (statement,) = ast.parse(piece).body
    except (SyntaxError, ValueError, TypeError):
        raise AuthorError(f"code(…) wants a piece of code in quotes; it got {piece!r}") from None
    return statement.value if isinstance(statement, ast.Expr) else statement


def _fits(pattern: Any, node: Any) -> bool:
    if isinstance(pattern, ast.Name) and pattern.id == "_":
        return isinstance(node, ast.expr)
    if isinstance(pattern, list):
        return (
            isinstance(node, list) and len(pattern) == len(node) and all(map(_fits, pattern, node))
        )
    if isinstance(pattern, ast.expr_context):
        return True
    if isinstance(pattern, ast.AST):
        fields = ((getattr(pattern, name), getattr(node, name, None)) for name in pattern._fields)
        return type(pattern) is type(node) and all(_fits(*pair) for pair in fields)
    return bool(pattern == node) and type(pattern) is type(node)
