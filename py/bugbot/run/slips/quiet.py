"""Programs that end without an error and yet did not do what was meant.

May import: the standard library, `bugbot.link`, the rest of `bugbot.run.slips`.

Their remarks are added to the message of the end.
"""

from __future__ import annotations

import ast
import warnings
from collections import Counter
from collections.abc import Iterator
from math import pi

from bugbot.link import Link
from bugbot.run.slips.case import CALLS

__all__ = ["remarks"]

_LONGEST_READ = 200_000
"""A longer program is not read through for remarks: no person wrote it [characters]."""

_MOST_REMARKS = 3

_SPEEDS = {"forward", "backward", "left", "right"}

_FIVE_DEGREES = pi / 36
"""In radians. A turn of a whole number of these is meant in radians: 1.5707963 is no accident."""


def remarks(source: str, link: Link) -> list[str]:
    """What to say about a program that came to its end, a sentence each."""
    if not source.strip():
        return ["The program is empty."]
    found = list(_about_the_run(link))
    if len(source) <= _LONGEST_READ:
        with warnings.catch_warnings():  # they have been shown when the program was compiled
            warnings.simplefilter("ignore")
            tree = ast.parse(source)
        found += _about_the_text(tree)
    return found[:_MOST_REMARKS]


def _about_the_run(link: Link) -> Iterator[str]:
    if link.sim.ever_driven and link.now() == 0.0:
        yield (
            "The robot was told to move, but no time passed: a program goes on at once, so "
            "let time pass with wait(), for example wait(2)."
        )
    for line, degrees in link.small_turns:
        steps = degrees / _FIVE_DEGREES
        if abs(steps - round(steps)) < 1e-6:
            where = "" if line is None else f"Line {line}: "
            yield (
                f"{where}turn({degrees:.5g}) is a turn of {degrees:.5g} degrees. That looks like "
                "radians: math.degrees(…) makes degrees of them."
            )
            return


def _about_the_text(tree: ast.Module) -> Iterator[str]:
    nodes = list(ast.walk(tree))
    stored = Counter(_names_given(nodes))
    functions = {each.name for each in nodes if isinstance(each, ast.FunctionDef)}
    calls = {name for name in CALLS if name not in stored and name not in functions}
    degrees = {name for name in _names_in_degrees(nodes) if stored[name] == 1}
    for node in nodes:
        line = f"Line {getattr(node, 'lineno', None)}"
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Name):
            name = node.value.id
            if name in calls or (name in functions and name not in stored):
                yield f"{line}: {name} does nothing without its brackets: {name}()"
        elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Compare):
            yield (
                f"{line} only compares, and nothing is done with the answer: one = gives a value "
                "to a name."
            )
        elif isinstance(node, ast.Assign) and _is_plus(node.value):
            name = ast.unparse(node.targets[0])
            yield f"{line}: =+ gives {name} a new value. To add to the old one write +="
        elif isinstance(node, ast.Call):
            yield from _about_a_call(node, line, calls, degrees)


def _about_a_call(node: ast.Call, line: str, calls: set[str], degrees: set[str]) -> Iterator[str]:
    name, first = _called(node), node.args[0] if node.args else None
    if name in ("sin", "cos", "tan") and first is not None:
        if _is_call(first, "heading") or (isinstance(first, ast.Name) and first.id in degrees):
            yield (
                f"{line}: {name}() wants radians, and this is in degrees: put math.radians(…) "
                "round it."
            )
    elif name == "print":
        for each in node.args:
            if isinstance(each, ast.Name) and each.id in calls:
                yield (f"{line} prints the function {each.id} itself: what it gives is {each.id}()")
    elif name == "draw" and len(node.args) > 1 and _is_call(node.args[1], "scan"):
        yield (
            f"{line}: scan() gives angles and distances, and draw() takes them for points (x, y) "
            "on the mat."
        )
    elif name in _SPEEDS & calls and isinstance(first, ast.Constant):
        share = first.value
        if isinstance(share, float) and 0 < share < 1:
            yield (
                f"{line}: speeds are in per cent, so {name}({share:g}) is less than one per cent. "
                f"{share:g} of full speed is {name}({100 * share:g})."
            )


def _names_given(nodes: list[ast.AST]) -> Iterator[str]:
    for node in nodes:
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.id
        elif isinstance(node, ast.arg):
            yield node.arg


def _names_in_degrees(nodes: list[ast.AST]) -> Iterator[str]:
    """Names that are given a heading, or the angle of a beam."""
    for node in nodes:
        if isinstance(node, ast.Assign) and _is_call(node.value, "heading"):
            yield from (each.id for each in node.targets if isinstance(each, ast.Name))
        elif isinstance(node, ast.Assign) and _is_call(node.value, "odometry"):
            target = node.targets[0]
            last = target.elts[-1] if isinstance(target, ast.Tuple) else None
            if isinstance(last, ast.Name):
                yield last.id
        elif isinstance(node, ast.For | ast.comprehension) and _is_call(node.iter, "scan"):
            first = node.target.elts[0] if isinstance(node.target, ast.Tuple) else None
            if isinstance(first, ast.Name):
                yield first.id


def _is_plus(node: ast.expr) -> bool:
    return isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.UAdd)


def _called(node: ast.Call) -> str:
    function = node.func
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


def _is_call(node: ast.expr, name: str) -> bool:
    return isinstance(node, ast.Call) and _called(node) == name
