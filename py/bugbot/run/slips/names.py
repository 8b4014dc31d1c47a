"""Slips in names: misspelt, not imported, not there yet, in quotes or not.

May import: the standard library, `bugbot.errors`, the rest of `bugbot.run.slips`.
"""

from __future__ import annotations

import builtins
import keyword
import math
import re

from bugbot.errors import nearest
from bugbot.run.slips.case import CALLS, Case, Slip
from bugbot.run.slips.copied import alike
from bugbot.run.slips.modules import MODULES

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
"""What other languages, and other robots, call it."""

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
    if near in own and near not in CALLS:
        return _two_spellings(case, near, name)
    if near in CALLS and near not in case.scope:
        return f"Did you mean {near}? It needs this line at the top: from bugbot import *"
    return _meant(near, name)


def _two_spellings(case: Case, near: str, name: str, quoted: bool = False) -> str:
    """Which of two names of the program's own is the slip, if one sees it; else where each is."""
    of_near, of_name = case.lines_with(near, quoted), case.lines_with(name, quoted)
    shown = (repr(near), repr(name)) if quoted else (near, name)
    if not of_near or not of_name or len(of_near) > max(1, len(of_name)):
        return f"Did you mean {shown[0]}?"
    return (
        f"It is spelt {shown[0]} on {_lines(of_near)} and {shown[1]} on {_lines(of_name)}: make "
        "them the same."
    )


def _lines(numbers: list[int]) -> str:
    first = [str(each) for each in numbers[:3]]
    if len(first) == 1:
        return f"line {first[0]}"
    return f"lines {', '.join(first[:-1])} and {first[-1]}"


def _meant(near: str, name: str) -> str:
    letters = " Capital and small letters count." if near.lower() == name.lower() else ""
    return f"Did you mean {near}?{letters}"


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
    if name in case.scope:
        return (
            f"The function gives {name} a value somewhere, so {name} is its own there. To change "
            f"the one outside, begin the function with: global {name}"
        )
    return f"On the way to this line nothing has given {name} a value: give it one before the if."


_METHODS = {
    "push": "append",
    "add": "append",
    "length": "len(…)",
    "size": "len(…)",
    "count": "len(…)",
}


def _attribute(case: Case) -> str | None:
    error = case.error
    if not isinstance(error, AttributeError) or not error.name:
        return None
    thing, name = error.obj, error.name
    if thing is None:
        return (
            "The value before the dot is None: a function without a return gives None, and so do "
            "append() and sort()."
        )
    if type(thing).__name__ in ("function", "builtin_function_or_method", "method"):
        called = getattr(thing, "__name__", "it")
        return f"{called} is a function: to use what it gives, call it with brackets: {called}()"
    if isinstance(thing, tuple) and name in ("x", "y", "heading"):
        return "This is a plain tuple: take it apart with x, y = position()"
    if isinstance(thing, list) and name in _METHODS:
        return f"For a list this is {_METHODS[name]}."
    near = nearest(name, [each for each in dir(thing) if not each.startswith("_")])
    if near and type(thing).__module__ == "__main__":
        return _two_spellings(case, near, name)
    return _meant(near, name) if near else None


def _key(case: Case) -> str | None:
    error = case.error
    if not isinstance(error, KeyError) or len(error.args) != 1:
        return None
    key = error.args[0]
    tables = [
        value
        for name in re.findall(r"\b([A-Za-z_]\w*)\s*\[", case.code)
        if isinstance(value := case.scope.get(name), dict)
    ]
    keys = [each for table in tables for each in table if isinstance(each, str)]
    near = nearest(key, keys) if isinstance(key, str) else None
    if near is not None:
        return _two_spellings(case, near, key, quoted=True)
    return "Ask first with: if key in table: … or take a default: table.get(key, 0)"


SLIPS: tuple[Slip, ...] = (
    _other_language,
    _self,
    _not_imported,
    _compared,
    _given_later,
    _misspelt,
    _unknown,
    _unbound,
    _attribute,
    _key,
)
