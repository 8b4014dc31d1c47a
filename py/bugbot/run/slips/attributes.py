"""Slips after a dot and in square brackets: attributes and keys that are not there.

May import: the standard library, `bugbot.api`, `bugbot.errors`, the rest of `bugbot.run.slips`.
"""

from __future__ import annotations

import re
from types import ModuleType

from bugbot.api import Robot
from bugbot.errors import nearest
from bugbot.run.slips.case import CALLS, Case, Slip
from bugbot.run.slips.spelling import meant, two_spellings

__all__ = ["SLIPS"]

_METHODS: dict[tuple[type, str], str] = {
    (list, "push"): "append",
    (list, "add"): "append",
    (list, "length"): "len(…)",
    (list, "size"): "len(…)",
    (list, "shape"): "len(…)",
    (set, "append"): "add",
    (set, "push"): "add",
    (tuple, "append"): "the work of a list: begin with [], not with ()",
    (str, "append"): "text + more",
    (dict, "append"): "table[key] = value",
    (dict, "add"): "table[key] = value. An empty set is set(), for {} is an empty dictionary",
    (dict, "has_key"): "key in table",
}
"""What a kind of value calls it."""


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
    if (type(thing), name) in _METHODS:
        return f"For a {type(thing).__name__} this is {_METHODS[type(thing), name]}."
    if type(thing).__name__ == "ndarray" and name in ("append", "extend", "push"):
        return "An array keeps its size: gather in a list, then make an array: np.array(gathered)"
    if isinstance(thing, ModuleType) and name in CALLS and thing.__name__ != "bugbot":
        return f"{name}() is the robot's own call: leave out {thing.__name__}."
    near = nearest(name, [each for each in dir(thing) if not each.startswith("_")])
    if type(thing).__module__ == "__main__":
        return _of_ones_own(case, thing, name, near)
    if isinstance(thing, type) and thing.__module__ == "__main__" and not near:
        return f"{thing.__name__} is the class: {thing.__name__}() makes an object of it."
    if isinstance(thing, Robot) and not near:
        return f"The robot's calls are {', '.join(CALLS)}."
    return meant(near, name) if near else None


def _of_ones_own(case: Case, thing: object, name: str, near: str | None) -> str | None:
    """`cells = {}` in a method, where `self.cells = {}` was meant; or two spellings."""
    for number, text in enumerate(case.lines, 1):
        if re.match(rf"\s+{re.escape(name)}\s*=(?!=)", text):
            return (
                f"If line {number} is to give the {type(thing).__name__} its {name}, it needs "
                f"self: self.{name} = …"
            )
    return two_spellings(case, near, name) if near else None


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
        return two_spellings(case, near, key, quoted=True)
    return "Ask first with: if key in table: … or take a default: table.get(key, 0)"


SLIPS: tuple[Slip, ...] = (_attribute, _key)
