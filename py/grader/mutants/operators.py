"""Small mistakes inside an expression: operators, numbers, names, calls.

May import: the standard library, `grader.mutants.edits`.

Each function takes a node and gives the changes that a learner might have made there.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from itertools import pairwise

from grader.mutants.edits import Edit, Source

__all__ = ["edits_of"]

_COMPARISONS: dict[type[ast.cmpop], tuple[str, tuple[str, ...]]] = {
    ast.Lt: ("<", ("<=", ">")),
    ast.LtE: ("<=", ("<", ">=")),
    ast.Gt: (">", (">=", "<")),
    ast.GtE: (">=", (">", "<=")),
    ast.Eq: ("==", ("!=",)),
    ast.NotEq: ("!=", ("==",)),
    ast.In: ("in", ("not in",)),
    ast.NotIn: ("not in", ("in",)),
    ast.Is: ("is", ("is not",)),
}
_ARITHMETIC: dict[type[ast.operator], tuple[str, tuple[str, ...]]] = {
    ast.Add: ("+", ("-",)),
    ast.Sub: ("-", ("+",)),
    ast.Mult: ("*", ("/",)),
    ast.Div: ("/", ("*", "//")),
    ast.FloorDiv: ("//", ("/", "%")),
    ast.Mod: ("%", ("//",)),
    ast.Pow: ("**", ("*",)),
    ast.BitOr: ("|", ("&",)),
    ast.BitAnd: ("&", ("|",)),
}
_INSTEAD = {
    "int": ("round", "floor", "ceil"),
    "round": ("int", "floor", "ceil"),
    "floor": ("int", "round", "ceil"),
    "ceil": ("int", "round", "floor"),
    "sin": ("cos",),
    "cos": ("sin",),
    "radians": ("degrees",),
    "degrees": ("radians",),
    "min": ("max",),
    "max": ("min",),
    "any": ("all",),
    "all": ("any",),
    "append": ("extend",),
    "extend": ("append",),
    "add": ("update",),
    "update": ("add",),
    "minimum": ("maximum",),
    "maximum": ("minimum",),
}
_ROUNDING = ("int", "round", "floor", "ceil")
_LEFT_OUT = (
    *("int", "round", "floor", "ceil", "trunc", "radians", "degrees", "min", "max", "abs"),
    *("sorted", "set", "list", "tuple", "minimum", "maximum", "float"),
)

_IN_ANY_ORDER = ("min", "max", "minimum", "maximum", "hypot")
"""Calls that answer the same, whatever the order of their arguments."""


def edits_of(source: Source, node: ast.AST, names: frozenset[str]) -> Iterator[Edit]:
    """The changes at one node; `names` are those that the program can use there."""
    if isinstance(node, ast.Compare):
        yield from _comparisons(source, node)
    elif isinstance(node, ast.BinOp):
        yield from _arithmetic(source, node)
    elif isinstance(node, ast.BoolOp):
        yield from _and_or(source, node)
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not | ast.USub):
        yield Edit("negation", source.span(node), source.bracketed(node.operand))
    elif isinstance(node, ast.Constant):
        yield from _numbers(source, node)
    elif isinstance(node, ast.Call):
        yield from _calls(source, node, names)
    elif isinstance(node, ast.Tuple):
        yield from _swapped(source, node.elts)
    elif isinstance(node, ast.Subscript):
        yield from _indices(source, node)
    elif isinstance(node, ast.IfExp):
        yield Edit("guard", source.span(node), source.bracketed(node.body))
        yield Edit("guard", source.span(node), source.bracketed(node.orelse))
    elif isinstance(node, ast.comprehension):
        for test in node.ifs:
            yield Edit("guard", source.span(test), "True")
            yield Edit("negation", source.span(test), f"not ({source.text(test)})")


def _comparisons(source: Source, node: ast.Compare) -> Iterator[Edit]:
    sides = [node.left, *node.comparators]
    for op, (left, right) in zip(node.ops, pairwise(sides), strict=True):
        known = _COMPARISONS.get(type(op))
        if known is not None:
            sign, others = known
            for other in others:
                yield Edit("comparison", source.between(left, right, sign), other)
    if len(node.ops) > 1:  # 0 <= a < 10: one side is not looked at
        yield Edit("guard", (source.span(node)[0], source.span(node.comparators[0])[0]), "")
        yield Edit("guard", (source.span(node.comparators[-2])[1], source.span(node)[1]), "")
    if len(node.ops) == 1 and isinstance(node.comparators[0], ast.Constant):
        if node.comparators[0].value is not None:
            return
        value = source.bracketed(node.left)
        if isinstance(node.ops[0], ast.IsNot):
            yield Edit("comparison", source.span(node), value)  # 0 and [] count as nothing
            span = source.between(node.left, node.comparators[0], "is not")
            yield Edit("comparison", span, "is")
        elif isinstance(node.ops[0], ast.Is):
            yield Edit("comparison", source.span(node), f"not {value}")


def _arithmetic(source: Source, node: ast.BinOp) -> Iterator[Edit]:
    known = _ARITHMETIC.get(type(node.op))
    if known is not None:
        sign, others = known
        for other in others:
            # Rounding down what has been rounded down is the same in every case.
            if (other, source.given_to(node)) != ("//", "floor"):
                yield Edit("arithmetic", source.between(node.left, node.right, sign), other)
    span = source.span(node)
    left, right = source.bracketed(node.left), source.bracketed(node.right)
    if isinstance(node.op, ast.FloorDiv) and source.given_to(node) not in _ROUNDING:
        yield Edit("rounding", span, f"round({left} / {right})")
        yield Edit("rounding", span, f"int({left} / {right})")
    yield Edit("left out", span, left)
    if isinstance(node.op, ast.Add | ast.Mult):
        yield Edit("left out", span, right)
    if isinstance(node.op, ast.Sub) and source.given_to(node) != "abs":
        yield Edit("swapped", span, f"{right} - {left}")
    if isinstance(node.op, ast.Div | ast.FloorDiv):
        yield Edit("swapped", span, f"{right} / {left}")


def _and_or(source: Source, node: ast.BoolOp) -> Iterator[Edit]:
    sign, other = ("and", "or") if isinstance(node.op, ast.And) else ("or", "and")
    for left, right in pairwise(node.values):
        yield Edit("and/or", source.between(left, right, sign), other)
    for left, right in pairwise(node.values):
        yield Edit("guard", (source.span(left)[0], source.span(right)[0]), "")
    last, before = node.values[-1], node.values[-2]
    yield Edit("guard", (source.span(before)[1], source.span(last)[1]), "")


def _numbers(source: Source, node: ast.Constant) -> Iterator[Edit]:
    value, span = node.value, source.span(node)
    if value is True or value is False:
        yield Edit("number", span, str(not value))
    elif isinstance(value, int):
        yield Edit("number", span, str(value + 1))
        yield Edit("number", span, str(value - 1) if value else "(-1)")
    elif isinstance(value, float):
        yield Edit("number", span, f"({value!r} + 1)")
        yield Edit("number", span, "0.0")


def _calls(source: Source, node: ast.Call, names: frozenset[str]) -> Iterator[Edit]:
    function = node.func
    called = function.id if isinstance(function, ast.Name) else getattr(function, "attr", "")
    if called not in _IN_ANY_ORDER:
        yield from _swapped(source, node.args)
    start, end = source.span(function)
    name = (end - len(called.encode()), end)
    whole_already = any(_is_whole(each) for each in node.args)
    for other in () if whole_already and called in _ROUNDING else _INSTEAD.get(called, ()):
        kind = "rounding" if called in _ROUNDING else "other call"
        if isinstance(function, ast.Attribute):
            module = source.text(function.value)
            plain = other in ("int", "round") and module == "math"
            yield Edit(kind, (start, end) if plain else name, other)
        elif other in names:
            yield Edit(kind, name, other)
        elif f"math.{other}" in names:
            yield Edit(kind, name, f"math.{other}")
    if called in _LEFT_OUT and not any(isinstance(each, ast.Starred) for each in node.args):
        whole = source.span(node)
        for each in node.args if called in ("min", "max") else node.args[:1]:
            yield Edit("left out", whole, source.bracketed(each))
    if called == "range" and node.args:
        stop = node.args[0] if len(node.args) == 1 else node.args[1]
        for change in (" + 1", " - 1"):
            yield Edit("off by one", source.span(stop), f"{source.bracketed(stop)}{change}")
        if len(node.args) == 1:
            yield Edit("off by one", source.span(stop), f"1, {source.text(stop)}")
        else:
            for change in (" + 1", " - 1"):
                first = node.args[0]
                yield Edit("off by one", source.span(first), f"{source.bracketed(first)}{change}")


def _is_whole(node: ast.expr) -> bool:
    return isinstance(node, ast.BinOp) and isinstance(node.op, ast.FloorDiv)


def _swapped(source: Source, parts: list[ast.expr]) -> Iterator[Edit]:
    for one, other in pairwise(parts):
        if isinstance(one, ast.Starred) or isinstance(other, ast.Starred):
            continue
        span = (source.span(one)[0], source.span(other)[1])
        gap = source.text((source.span(one)[1], source.span(other)[0]))
        yield Edit("swapped", span, f"{source.text(other)}{gap}{source.text(one)}")


def _indices(source: Source, node: ast.Subscript) -> Iterator[Edit]:
    if isinstance(node.ctx, ast.Del) or not isinstance(node.slice, ast.Name | ast.BinOp):
        return
    for change in (" + 1", " - 1"):
        span = source.span(node.slice)
        yield Edit("off by one", span, f"{source.bracketed(node.slice)}{change}")
