"""Answers of another kind than the task asks for: a text for a number, a list for a set.

May import: the standard library, `grader.compare`, `performer.values`.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite, isnan
from typing import Any

from grader.compare import in_any_order
from performer.values import DecimalFloat, Other, shown

__all__ = ["other_kind"]

_LAZY = (
    "a generator",
    "a map",
    "a filter",
    "a zip",
    "an enumerate",
    "a dict_keys",
    "a dict_values",
    "a dict_items",
)


def other_kind(right: Any, value: Any, rights: Sequence[Any] = ()) -> str | None:
    """In what kind the answer differs from what is asked, and what to do; None if in none.

    rights  what is right for all calls: of a kind that one of them has no answer is wrong
    """
    known = {_sort(each) for each in (right, *rights)}
    if _sort(value) in known:
        return _inside(right, value) if _sort(value) == _sort(right) else None
    return _differs("it", right, value)


def _inside(right: Any, value: Any, place: str = "") -> str | None:
    """The first part that is of another kind than its partner."""
    what = f"{place.removeprefix(' of ')} (counted from 0)" if place else "it"
    if isinstance(right, int | float) and isinstance(value, float):
        if isnan(value) and not isnan(right):
            return f"{what} is nan, which comes from sums without an answer, like inf - inf"
        if not isfinite(value) and isfinite(right):
            return (
                f"{what} is infinite: look where something is divided by 0, or never gets a value"
            )
        return None
    if not (isinstance(right, list | tuple) and isinstance(value, list | tuple)):
        return None
    if len(right) != len(value):
        if not right or len({_sort(each) for each in (*right, *value)}) == 1:
            return None
        right = [right[0]] * len(value) if len({_sort(each) for each in right}) == 1 else right
    for index, (part, other) in enumerate(zip(right, value, strict=False)):
        here = f"item {index}{place}"
        if part is None or other is None:
            continue  # that may be a part of the task
        found = (
            _inside(part, other, f" of {here}")
            if _sort(part) == _sort(other)
            else _differs(f"{here} (counted from 0)", part, other)
        )
        if found is not None:
            return found
    return None


def _differs(what: str, right: Any, value: Any) -> str | None:
    wanted = kind(right)
    if isinstance(value, Other):
        if value.what in _LAZY and isinstance(right, list | tuple | set):
            name = type(right).__name__
            return f"{what} is {value.what}, which is no {name} yet: put {name}() round it"
        return f"{what} is {value.what}; the task asks for {wanted}"
    if isinstance(value, str):
        rest = "leave out the quotes, str() and f-strings"
        return f"{what} is a text, {shown(value)}; the task asks for {wanted}: {rest}"
    if isinstance(value, bool):
        return f"{what} is {value}; the task asks for {wanted}"
    if isinstance(right, set) and isinstance(value, list | tuple):
        same = ": set(…)" if in_any_order(right, value) else ""
        return f"{what} is {kind(value)}; the task asks for a set{same}"
    if isinstance(right, list | tuple) and isinstance(value, set | frozenset):
        return f"{what} is a set, which has no order; the task asks for {wanted}"
    if right is None:
        return None  # what else it may be, the checks know better
    return f"{what} is {kind(value)}; the task asks for {wanted}"


def _sort(value: Any) -> str:
    """Values of one sort can stand for each other; no more is said here."""
    for name, kinds in (
        ("none", type(None)),
        ("truth", bool),
        ("number", (int, float)),
        ("row", (list, tuple)),
        ("set", (set, frozenset)),
        ("text", str),
        ("dict", dict),
    ):
        if isinstance(value, kinds):
            return name
    return "other"


def kind(value: Any) -> str:
    """What a value is, with an article.

    >>> kind((1, 2)), kind([]), kind(2.0)
    ('a tuple of 2, such as (1, 2)', 'an empty list', 'a number')
    """
    if isinstance(value, tuple) and 0 < len(value) <= 4:
        return f"a tuple of {len(value)}, such as {shown(value)}"
    if isinstance(value, list | tuple | set | frozenset | dict) and not value:
        return f"an empty {type(value).__name__}"
    names: dict[type, str] = {
        list: "a list",
        tuple: "a tuple",
        set: "a set",
        frozenset: "a frozenset",
        dict: "a dict",
        str: "a text",
        DecimalFloat: "a Decimal",
    }
    if isinstance(value, bool):
        return "True or False"
    if type(value) in names:
        return names[type(value)]
    if isinstance(value, int):
        return "a whole number"
    return "a number" if isinstance(value, float) else shown(value)
