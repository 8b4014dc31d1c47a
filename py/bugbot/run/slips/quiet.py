"""Programs that end without an error and yet did not do what was meant.

May import: the standard library, `bugbot.link`, the rest of `bugbot.run.slips`.

Their remarks are added to the message of the end.
"""

from __future__ import annotations

import ast
import warnings
from collections.abc import Iterator
from math import pi

from bugbot.link import Link
from bugbot.run.slips.case import CALLS

__all__ = ["remarks"]

_LONGEST_READ = 200_000
"""A longer program is not read through for remarks: no person wrote it [characters]."""

_MOST_REMARKS = 3

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
    in_degrees = {"heading"}
    """Calls and names that stand for degrees."""
    covered = set()
    """Names that the program has given a meaning of its own."""
    for node in nodes:
        if isinstance(node, ast.Assign) and _is_call(node.value, "heading"):
            in_degrees.update(each.id for each in node.targets if isinstance(each, ast.Name))
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            covered.add(node.id)
    for node in nodes:
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Name):
            name = node.value.id
            if name in CALLS and name not in covered:
                yield f"Line {node.lineno}: {name} does nothing without its brackets: {name}()"
        elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Compare):
            yield (
                f"Line {node.lineno} only compares, and nothing is done with the answer: one = "
                "gives a value to a name."
            )
        elif isinstance(node, ast.Call) and _called(node) in ("sin", "cos", "tan") and node.args:
            angle = node.args[0]
            if _is_call(angle, "heading") or (
                isinstance(angle, ast.Name) and angle.id in in_degrees
            ):
                yield (
                    f"Line {node.lineno}: {_called(node)}() wants radians, and this is in degrees: "
                    f"put math.radians(…) round it."
                )


def _called(node: ast.Call) -> str:
    function = node.func
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


def _is_call(node: ast.expr, name: str) -> bool:
    return isinstance(node, ast.Call) and _called(node) == name
