"""Why a call of the learner's function came back with None, read from the function.

May import: the standard library, `grader.text`.

Only what is certain is said: the performer tells on which line the function was left.
"""

from __future__ import annotations

import ast

from grader.text import Text

__all__ = ["why_none"]

_IN_PLACE = frozenset(
    ("append", "extend", "insert", "add", "update", "sort", "reverse", "remove", "discard",
     "clear", "shuffle")
)  # fmt: skip
"""Methods that change what they belong to and return None."""


def why_none(text: Text, left_on: object, *, printed: bool) -> str | None:
    """Why it returned None, in words for the learner; None if that is not certain.

    left_on  the line on which the function was left, if the performer knows it
    printed  whether the call printed something
    """
    if not isinstance(text.function, ast.FunctionDef):
        return None
    returns = [each for each in text.own_nodes() if isinstance(each, ast.Return)]
    if not any(_gives_a_value(each) for each in returns):
        if printed:
            return (
                "it prints its answer instead of returning it: print() only shows a value, "
                "return hands it to the caller"
            )
        if any(each.value is not None for each in returns):
            return None  # None may be what was chosen
        return "a function hands back its answer with return, and this one has no return"
    if not isinstance(left_on, int):
        return None
    last = next((each for each in returns if each.lineno <= left_on <= _end(each)), None)
    if last is not None:
        return _of_return(last)
    return (
        f"it reached its end without a return: line {left_on} was the last to run, and a "
        "function that ends without a return gives None"
    )


def _of_return(statement: ast.Return) -> str | None:
    value = statement.value
    if value is None:
        return f"the return on line {statement.lineno} has nothing after it, and so gives None"
    if not isinstance(value, ast.Call):
        return None
    called = value.func
    if isinstance(called, ast.Name) and called.id == "print":
        return f"print() itself gives None, and line {statement.lineno} returns just that"
    if isinstance(called, ast.Attribute) and called.attr in _IN_PLACE:
        return (
            f"line {statement.lineno} returns what {called.attr}() gives, and that is None: "
            f"{called.attr}() changes the thing itself, so call it first and return the thing on "
            "the next line"
        )
    return None


def _end(node: ast.stmt) -> int:
    return node.end_lineno or node.lineno


def _gives_a_value(statement: ast.Return) -> bool:
    value = statement.value
    return value is not None and not (isinstance(value, ast.Constant) and value.value is None)
