"""Values on their way between a learner's program and its judge, and as messages show them.

May import: the standard library, `bugbot.errors`.

A value is taken apart by its exact type into plain JSON and put together again on the other
side. So what a program's own class says of itself (`__eq__` that is always True, `__repr__`
that shows the right answer) never reaches the judge. An integer is a JSON number; a
float is written as text, because JavaScript on the way would make 2 of 2.0.
"""

from __future__ import annotations

from array import array
from collections import deque
from decimal import Decimal
from fractions import Fraction
from math import isfinite
from typing import Any

from bugbot.errors import with_article

__all__ = ["DecimalFloat", "MalformedError", "Other", "decoded", "encoded", "shown"]

_MOST_PARTS = 50_000
_DEEPEST = 12
_LONGEST_TEXT = 100_000
_EXACT = 2**53
"""Integers beyond this do not survive as JSON numbers."""


_LONGEST_INT = 1000
"""Bits: a longer whole number is described, not shown."""


class MalformedError(Exception):
    """What came back is not what `encoded` makes."""


class Other:
    """Stands for an answer that is no plain value; `what` says what it was."""

    def __init__(self, what: str) -> None:
        self.what = what


class DecimalFloat(float):
    """A number that was a Decimal: it counts as a float, and may be named."""


class _TooMuchError(Exception):
    pass


def encoded(value: object) -> Any:
    """The value as JSON; what is no plain value becomes {"other": its type's name}.

    >>> encoded((2, 1.5, None))
    {'tuple': [2, {'float': '1.5'}, None]}
    """
    parts = [0]
    try:
        return _encode(value, 0, parts)
    except _TooMuchError:
        return {"other": f"{_a(value)} of more than {_MOST_PARTS} parts, or {_DEEPEST} deep"}


def _encode(value: Any, depth: int, parts: list[int]) -> Any:
    parts[0] += 1
    if parts[0] > _MOST_PARTS or depth > _DEEPEST:
        raise _TooMuchError
    kind = type(value)
    if value is None or kind is bool:
        return value
    if issubclass(kind, str):
        return str.__str__(value)[:_LONGEST_TEXT]
    if issubclass(kind, int):
        number = int.__add__(value, 0)
        if number.bit_length() > _LONGEST_INT:
            return {"other": f"a whole number of some {number.bit_length() * 3 // 10:,} digits"}
        return number if -_EXACT < number < _EXACT else {"int": hex(number)}
    if issubclass(kind, float):
        return {"float": repr(float.__add__(value, 0.0))}
    if kind is Fraction or kind is Decimal:
        return _rational(value)
    if kind in (range, bytes, bytearray, array):
        return _encode(list(value[: _MOST_PARTS + 1]), depth, parts)
    if kind.__module__ == "numpy" and hasattr(value, "tolist"):
        return _encode(value.tolist(), depth, parts)
    if kind is list and value and all(type(each) is float for each in value):
        parts[0] += len(value)
        if all(map(isfinite, value)) and parts[0] <= _MOST_PARTS:
            return {"floats": list.copy(value)}
    if issubclass(kind, list):
        return [_encode(each, depth + 1, parts) for each in list.__iter__(value)]
    if issubclass(kind, deque):
        return [_encode(each, depth + 1, parts) for each in deque.__iter__(value)]
    if issubclass(kind, tuple):
        return {"tuple": [_encode(each, depth + 1, parts) for each in tuple.__iter__(value)]}
    if issubclass(kind, set):
        return {"set": [_encode(each, depth + 1, parts) for each in set.__iter__(value)]}
    if issubclass(kind, frozenset):
        return {"set": [_encode(each, depth + 1, parts) for each in frozenset.__iter__(value)]}
    if issubclass(kind, dict):
        pairs = dict.items(value)
        return {"dict": [[_encode(part, depth + 1, parts) for part in pair] for pair in pairs]}
    return {"other": _a(value)}


def _rational(value: Fraction | Decimal) -> Any:
    """A number by another name: whole if it is, else a float."""
    if isinstance(value, Fraction) and value.denominator == 1:
        return _encode(value.numerator, 0, [0])
    try:
        return {"decimal" if isinstance(value, Decimal) else "float": repr(float(value))}
    except (OverflowError, ValueError):
        return {"other": _a(value)}


def _a(value: object) -> str:
    """The value's type with its article: a Cell, an Answer."""
    return with_article(type(value).__name__[:60])


def decoded(data: Any) -> Any:
    """The value again; raises MalformedError for anything that `encoded` can't have made.

    >>> decoded({"tuple": [2, {"float": "1.5"}]})
    (2, 1.5)
    """
    try:
        return _decode(data)
    except (TypeError, ValueError, KeyError, OverflowError, RecursionError) as error:
        raise MalformedError(str(error)) from None


def _decode(data: Any) -> Any:
    if data is None or isinstance(data, bool | str | int):
        return data
    if isinstance(data, float):  # an integer that has been through JavaScript
        return int(data)
    if isinstance(data, list):
        return [_decode(each) for each in data]
    ((tag, content),) = data.items()
    if tag == "float":
        return float(content)
    if tag == "decimal":
        return DecimalFloat(content)
    if tag == "floats":
        return [float(each) for each in content]
    if tag == "int":
        return int(content, 16)
    if tag == "tuple":
        return tuple(_decode(each) for each in content)
    if tag == "set":
        return {_frozen(_decode(each)) for each in content}
    if tag == "dict":
        return {_frozen(_decode(key)): _decode(value) for key, value in content}
    if tag == "other":
        return Other(str(content)[:200])
    raise ValueError(f"no such tag: {tag}")


def _frozen(value: Any) -> Any:
    """As a part of a set or a key of a dict: what can't be one becomes what can."""
    if isinstance(value, set | frozenset):
        return frozenset(map(_frozen, value))
    if isinstance(value, list | tuple):
        return tuple(map(_frozen, value))
    return frozenset(map(_frozen, value.items())) if isinstance(value, dict) else value


# -- in words ------------------------------------------------------------------

_MOST_SHOWN = 8
_MOST_NUMBERS = 24
_LONGEST_SHOWN = 60


def shown(value: object) -> str:
    """A value as a message shows it: short, floats to six decimals.

    >>> shown((1.00000001, [1, 2, 3, 4, 5, 6, 7, 8, 9, 10], "a"))
    "(1.0, [1, 2, 3, 4, 5, 6, 7, 8, … 2 more], 'a')"
    """
    if isinstance(value, Other):
        return value.what
    if isinstance(value, float):
        return repr(round(value, 6) + 0.0)
    if isinstance(value, str):
        text = repr(value)
        return text if len(text) <= _LONGEST_SHOWN else f"{text[: _LONGEST_SHOWN - 1]}…"
    if isinstance(value, tuple):
        return f"({_items(value)}{',' if len(value) == 1 else ''})"
    if isinstance(value, list):
        return _list(value)
    if isinstance(value, set | frozenset):
        return f"{{{_items(sorted(value, key=shown))}}}" if value else "set()"
    if isinstance(value, dict):
        pairs = [f"{shown(key)}: {shown(each)}" for key, each in list(value.items())[:_MOST_SHOWN]]
        return f"{{{', '.join(pairs)}{_more(value)}}}"
    text = repr(value)
    return text if len(text) <= _LONGEST_SHOWN else f"{text[: _LONGEST_SHOWN - 1]}…"


def _list(values: list[Any]) -> str:
    if len(values) > _MOST_SHOWN and all(type(each) in (int, float) for each in values):
        if all(each == values[0] for each in values):
            return f"[{shown(values[0])}] * {len(values)}"
        if len(values) > _MOST_NUMBERS:
            return f"a list of {len(values)} numbers"
    return f"[{_items(values)}]"


def _items(values: Any) -> str:
    listed = list(values)
    return ", ".join(map(shown, listed[:_MOST_SHOWN])) + _more(listed)


def _more(values: Any) -> str:
    left_out = len(values) - _MOST_SHOWN
    return f", … {left_out} more" if left_out > 0 else ""
