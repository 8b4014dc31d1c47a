"""Whether a learner's function has a loop, and where: for tasks that are to be done without one.

May import: the standard library, `grader.text`.

A loop is a `for` or `while`, a comprehension, a call like map() that goes through its items one by
one, sorted() with a key, and a function that calls itself. What goes through at most four things
that are written out, such as `for v in (x, y)`, or through the columns of a parameter, `points.T`,
is no loop over points. The statements of the tasks say the same.
"""

from __future__ import annotations

import ast

from grader.text import Text

__all__ = ["loop_in"]

_FEW = 4
_LONG = f" (only one over at most {_FEW} things that you write out is allowed)"

_ONE_BY_ONE = frozenset(
    ("map", "filter", "filterfalse", "starmap", "takewhile", "dropwhile", "groupby", "reduce",
     "accumulate", "vectorize", "frompyfunc", "fromiter", "apply_along_axis", "apply_over_axes",
     "nditer", "ndenumerate", "ndindex")
)  # fmt: skip
"""Calls that go through their items one by one in Python."""

_SORTING = frozenset(("sorted", "sort", "min", "max"))
"""Calls that do so if they are given a key."""

_Comprehension = ast.ListComp | ast.SetComp | ast.DictComp | ast.GeneratorExp


def loop_in(text: Text) -> tuple[int, str] | None:
    """The line of the first loop in what the learner has written, and what it is."""
    if text.begin is None:
        return None
    parts = {id(each): each for each in (text.begin, *text.definitions)}
    found = [
        (node.lineno, what)
        for part in parts.values()
        for node in ast.walk(part)
        if isinstance(node, ast.expr | ast.stmt) and text.is_written(node)
        if (what := _loop(node, part, text)) is not None
    ]
    found += [
        (each.lineno, f"a function that calls itself, {each.name}()")
        for each in text.definitions
        if isinstance(each, ast.FunctionDef) and _comes_back(each, text)
    ]
    return min(found, default=None)


def _loop(node: ast.AST, part: ast.AST, text: Text) -> str | None:
    if isinstance(node, ast.While):
        return "a while loop"
    if isinstance(node, ast.For | ast.AsyncFor):
        return None if _is_short(node.iter, part, text) else f"a for loop{_LONG}"
    if isinstance(node, _Comprehension):
        short = all(_is_short(each.iter, part, text) for each in node.generators)
        return None if short else f"a comprehension{_LONG}"
    if isinstance(node, ast.Call) and _name(node.func) in _SORTING:
        keyed = any(each.arg == "key" for each in node.keywords)
        return f"{_name(node.func)}() with a key, which is asked for each item" if keyed else None
    name = _name(node)
    named = (each for each in text.definitions if isinstance(each, ast.FunctionDef))
    if name in _ONE_BY_ONE and name not in text.stored | {each.name for each in named}:
        return f"{name}(), which goes through the items one by one"
    return None


def _name(node: ast.AST) -> str | None:
    if isinstance(node, ast.Attribute):
        return node.attr
    return node.id if isinstance(node, ast.Name) else None


def _is_short(items: ast.expr, part: ast.AST, text: Text) -> bool:
    """Whether there are as many items whatever the number of points."""
    if isinstance(items, ast.Tuple | ast.List | ast.Set):
        plain = not any(isinstance(each, ast.Starred) for each in items.elts)
        return plain and len(items.elts) <= _FEW
    if isinstance(items, ast.Constant):
        return isinstance(items.value, str) and len(items.value) <= _FEW
    if isinstance(items, ast.Attribute) and items.attr == "T":
        parameters = {n.arg for n in ast.walk(part) if isinstance(n, ast.arg)}
        values = {n.id for n in text.nodes if isinstance(n, ast.Name) and _is_stored(n)}
        return isinstance(items.value, ast.Name) and items.value.id in parameters - values
    if isinstance(items, ast.Call) and isinstance(items.func, ast.Name):
        if items.func.id == "range":
            return all(
                isinstance(each, ast.Constant)
                and isinstance(each.value, int)
                and abs(each.value) <= _FEW
                for each in items.args
            )
        if items.func.id in ("zip", "enumerate", "reversed"):
            return any(_is_short(each, part, text) for each in items.args)
    return False


def _is_stored(node: ast.Name) -> bool:
    return isinstance(node.ctx, ast.Store)


def _comes_back(function: ast.FunctionDef, text: Text) -> bool:
    """Whether a function calls itself, at once or by way of others."""
    by_name = {each.name: each for each in text.definitions if isinstance(each, ast.FunctionDef)}
    seen: set[str] = set()
    waiting = [function.name]
    while waiting:
        defined = by_name.get(waiting.pop())
        if defined is None:
            continue
        for node in ast.walk(defined):
            name = _name(node.func) if isinstance(node, ast.Call) else None
            if name == function.name:
                return True
            if name is not None and name not in seen:
                seen.add(name)
                waiting.append(name)
    return False
