"""Slips in names: misspelt, not imported, not there yet, in quotes or not.

May import: the standard library, `bugbot.errors`, the rest of `bugbot.run.slips`.
"""

from __future__ import annotations

import ast
import builtins
import keyword
import math
import re
from dataclasses import replace

from bugbot.errors import nearest
from bugbot.run.slips.case import CALLS, Case, Slip
from bugbot.run.slips.copied import alike
from bugbot.run.slips.modules import MODULES
from bugbot.run.slips.spelling import is_own, meant, two_spellings

__all__ = ["SLIPS"]

_OTHER_WORDS = {
    "true": "True",
    "false": "False",
    "null": "None",
    "none": "None",
    "nil": "None",
    "undefined": "None",
    "sleep": "wait",
    "delay": "wait",
    "pause": "wait",
    "log": "print",
    "echo": "print",
    "printf": "print",
    "println": "print",
}
"""What other languages call it."""

_OTHER_ROBOTS = {
    **dict.fromkeys(("move", "go_forward", "move_forward", "drive_forward"), "forward(50)"),
    **dict.fromkeys(("go_back", "move_backward", "drive_backward", "reverse"), "backward(50)"),
    **dict.fromkeys(("turn_left", "rotate_left"), "turn(-90)"),
    **dict.fromkeys(("turn_right", "rotate_right", "rotate"), "turn(90)"),
    **dict.fromkeys(("get_distance", "read_distance", "ultrasonic"), "distance()"),
    **dict.fromkeys(("get_position", "get_pose", "pose"), "position()"),
    **dict.fromkeys(("get_heading", "get_angle", "yaw"), "heading()"),
    **dict.fromkeys(("halt", "brake"), "stop()"),
}
"""What other robots call it."""

_USUAL = {"np": "import numpy as np", "plt": "nothing: draw charts with plot(name, value)"}


def _name(case: Case) -> str | None:
    error = case.error
    if not isinstance(error, NameError) or isinstance(error, UnboundLocalError):
        return None
    return error.name or None


def _other_language(case: Case) -> str | None:
    name = _name(case)
    if name in _OTHER_WORDS and name not in case.scope:
        return f"In Python this is written {_OTHER_WORDS[name]}."
    if name in _OTHER_ROBOTS:
        return f"This robot's call for it is {_OTHER_ROBOTS[name]}."
    if name == "robot":
        return "Put this line above: robot = connect(). Or leave out robot. and call forward(50)."
    return None


def _self(case: Case) -> str | None:
    if _name(case) == "self":
        return "A method takes self as its first argument: def name(self, …):"
    return None


def _not_imported(case: Case) -> str | None:
    name = _name(case)
    if name is None:
        return None
    if name in CALLS and "bugbot" in case.scope:
        return f"The name is inside bugbot: write bugbot.{name}, or from bugbot import *"
    if name in CALLS or name == "Robot":
        return "Put this line at the top of the program: from bugbot import *"
    if name in _USUAL:
        return f"Put this line at the top of the program: {_USUAL[name]}"
    if name in MODULES:
        return f"Put this line at the top of the program: import {name}"
    if name in vars(math):
        if "math" in case.scope:
            return f"The name is inside math: write math.{name}"
        return f"Put this line at the top of the program: from math import {name}"
    return None


def _compared(case: Case) -> str | None:
    name = _name(case)
    if name and re.match(rf"\s*{name}\s*==[^=]*$", case.code):
        return f"To give {name} a value write one equals sign: {name} = …; two of them compare."
    return None


def _given_later(case: Case) -> str | None:
    name = _name(case)
    if name is None or case.line is None:
        return None
    gives = re.compile(rf"\s*(?:def\s+{name}\b|class\s+{name}\b|{name}\s*=(?!=))")
    for number in range(case.line + 1, len(case.lines) + 1):
        if gives.match(case.text_of(number)):
            return f"{name} first gets its value on line {number}, after this line: move that up."
    return None


def _misspelt(case: Case) -> str | None:
    name = _name(case)
    if name is None:
        return None
    own = [each for each in case.scope if not each.startswith("__")]
    for each in own:
        if same := alike(case, name, each):
            return same
    near = nearest(name, [*own, *CALLS, *dir(builtins), *keyword.kwlist])
    if near is None:
        return None
    if near in own and is_own(case.scope[near]):
        return two_spellings(case, near, name)
    if near in CALLS and near not in case.scope:
        return f"Did you mean {near}? It needs this line at the top: from bugbot import *"
    return meant(near, name)


def _unknown(case: Case) -> str | None:
    name = _name(case)
    if name is None:
        return None
    return (
        f"Nothing is called {name} here. A text needs quotes, '{name}'; a value needs a line above "
        f"that gives it: {name} = …"
    )


def _unbound(case: Case) -> str | None:
    if not isinstance(case.error, UnboundLocalError):
        return None
    found = re.search(r"'(\w+)'", case.message)
    name = found[1] if found else "it"
    given = [line for line in _given(case, name) if line != case.line]
    earlier = [line for line in given if case.line is not None and line < case.line]
    if not earlier and name in case.scope:
        return (
            f"The function gives {name} a value somewhere, so {name} is its own there. To change "
            f"the one outside, begin the function with: global {name}"
        )
    if not earlier:
        where = f" before line {given[0]}" if given else ""
        return f"Nothing has given {name} a value{where} yet: give it one above this line."
    block = _block_of(case, earlier[-1])
    if block is None:
        return f"Line {earlier[-1]} gives {name} a value, and the function has not come by there."
    kind, line = block
    return (
        f"{name} gets its value on line {earlier[-1]}, inside the {kind} of line {line}, and the "
        f"function has not come by there: give it one before that {kind} as well."
    )


def _given(case: Case, name: str) -> list[int]:
    """The lines of the function of this line that give the name a value."""
    functions = case.parts(ast.FunctionDef, ast.AsyncFunctionDef)
    if not functions:
        return []
    nodes = [node for node in ast.walk(functions[-1]) if isinstance(node, ast.Name)]
    return sorted({n.lineno for n in nodes if n.id == name and isinstance(n.ctx, ast.Store)})


_BLOCKS: dict[type[ast.AST], str] = {
    ast.If: "if",
    ast.For: "for",
    ast.While: "while",
    ast.Try: "try",
    ast.Match: "match",
}


def _block_of(case: Case, line: int) -> tuple[str, int] | None:
    """The outermost block round a line that is not round the learner's line as well."""
    here = {each.lineno for each in case.parts(*_BLOCKS)}
    blocks = replace(case, line=line).parts(*_BLOCKS)
    own = {each.lineno: _BLOCKS[type(each)] for each in blocks if each.lineno not in here}
    return (own[min(own)], min(own)) if own else None


SLIPS: tuple[Slip, ...] = (
    _other_language,
    _self,
    _not_imported,
    _compared,
    _given_later,
    _misspelt,
    _unknown,
    _unbound,
)
