"""How an answer is compared with what is right.

May import: the standard library, `bugbot.errors`, `grader.failures`, `performer.values`.

Lists and tuples count as the same everywhere: a learner who answers [2, 1] for (2, 1) has
understood. True and False are no numbers.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable
from dataclasses import dataclass
from math import isclose, isnan
from typing import Any

from bugbot.errors import counted
from grader.failures import AuthorError
from performer.values import Other, shown

__all__ = ["Compare", "difference", "exactly", "in_any_order", "near"]

Compare = Callable[[Any, Any], bool]
"""compare(expected, got): whether the answer is right."""

_Numbers = Callable[[float, float], bool]


def exactly(expected: Any, got: Any) -> bool:
    """The same value; a float is no whole number, and floats may differ in their last digits.

    >>> exactly((2, 1), [2, 1]), exactly(2, 2.0), exactly(0.3, 0.1 + 0.2)
    (True, False, True)
    """
    return _same(expected, got, _alike)


def _alike(expected: float, got: float) -> bool:
    if isinstance(expected, int):
        return isinstance(got, int) and expected == got
    return isclose(expected, got, rel_tol=1e-9, abs_tol=1e-9) or (isnan(expected) and isnan(got))


@dataclass(frozen=True, slots=True)
class near:  # noqa: N801 - a word of the vocabulary
    """Numbers within so much of each other, wherever they are in the answer; all else exactly.

    >>> near(0.5, "cm")((1, "a"), (1.4, "a"))
    True
    """

    within: float
    unit: str = ""

    def __post_init__(self) -> None:
        if isinstance(self.within, bool) or not isinstance(self.within, int | float):
            raise AuthorError(
                f"near(within, unit) wants a number for within; it got {self.within!r}"
            )

    def __call__(self, expected: Any, got: Any) -> bool:
        """Whether the answer is right."""
        return _same(expected, got, self._close)

    def _close(self, expected: float, got: float) -> bool:
        # Equal first: two infinities are equal, and their difference is not a number.
        return expected == got or abs(expected - got) <= self.within


@dataclass(frozen=True, slots=True)
class _InAnyOrder:
    levels: int = 1

    def __call__(self, expected: Any, got: Any) -> bool:
        return _unordered(expected, self.levels) == _unordered(got, self.levels)

    def deep(self, levels: int) -> _InAnyOrder:
        """The order inside the parts does not matter either, so many levels down."""
        return _InAnyOrder(levels)


in_any_order = _InAnyOrder()
"""The same parts as often as there, in any order; `in_any_order.deep(2)`: inside them as well."""


def _same(expected: Any, got: Any, alike: _Numbers) -> bool:
    if _is_number(expected) and _is_number(got):
        return alike(expected, got)
    if isinstance(expected, list | tuple) and isinstance(got, list | tuple):
        return len(expected) == len(got) and all(
            _same(*pair, alike) for pair in zip(expected, got, strict=True)
        )
    if isinstance(expected, dict) and isinstance(got, dict):
        return expected.keys() == got.keys() and all(
            _same(value, got[key], alike) for key, value in expected.items()
        )
    if isinstance(expected, set | frozenset) and isinstance(got, set | frozenset):
        return in_any_order(expected, got)
    return type(expected) is type(got) and not isinstance(got, Other) and bool(expected == got)


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _unordered(value: Any, levels: int) -> Hashable:
    """The value as a key that is equal for equal values, whatever their order so many levels."""
    if levels and isinstance(value, list | tuple | set | frozenset):
        return "parts", frozenset(Counter(_unordered(each, levels - 1) for each in value).items())
    if isinstance(value, list | tuple):
        return "row", tuple(_unordered(each, 0) for each in value)
    if isinstance(value, set | frozenset):
        return "parts", frozenset((_unordered(each, 0), 1) for each in value)
    if isinstance(value, dict):
        return "dict", frozenset((key, _unordered(each, 0)) for key, each in value.items())
    if isinstance(value, float):
        return "float", round(value, 9)
    if isinstance(value, Other):
        return "other", id(value)
    return type(value).__name__, value


_LONG = 8
"""Rows of more parts than this are not shown whole, but where they differ."""


def difference(compare: Compare, expected: Any, got: Any) -> tuple[str, str]:
    """What was expected and what was got, in words that differ; of long rows, where they part.

    >>> difference(exactly, list(range(20)), [*range(19), 7])
    ('item 19 (counted from 0) is 19', 'it is 7')
    """
    right, wrong = _difference(compare, expected, got)
    if right != wrong:
        return right, wrong
    return f"{right} ({_exact(expected)})", f"{wrong} ({_exact(got)})"


def _difference(compare: Compare, expected: Any, got: Any) -> tuple[str, str]:
    if isinstance(expected, set | frozenset) and isinstance(got, set | frozenset):
        if max(len(expected), len(got)) > _LONG or shown(expected) == shown(got):
            return _what_is_missing(sorted(expected, key=shown), sorted(got, key=shown))
        return shown(expected), shown(got)
    both_rows = all(isinstance(each, list | tuple) for each in (expected, got))
    same = shown(expected) == shown(got)
    if not both_rows or (max(len(expected), len(got)) <= _LONG and not same):
        return shown(expected), shown(got)
    if isinstance(compare, _InAnyOrder):
        return _what_is_missing(expected, got)
    if len(expected) != len(got):
        return (
            f"{counted(len(expected), 'item')}: {shown(expected)}",
            f"{counted(len(got), 'item')}: {shown(got)}",
        )
    for index, (right, wrong) in enumerate(zip(expected, got, strict=True)):
        if not compare(right, wrong):
            is_, it_is = difference(compare, right, wrong)
            return f"item {index} (counted from 0) is {is_}", f"it is {it_is}"
    return shown(expected), shown(got)


_LONGEST_EXACT = 60


def _exact(value: Any) -> str:
    """A value with its type and all its digits, for two that look alike."""
    text = repr(value)
    cut = text if len(text) <= _LONGEST_EXACT else f"{text[: _LONGEST_EXACT - 1]}…"
    return f"the {type(value).__name__} {cut}"


def _what_is_missing(expected: Any, got: Any) -> tuple[str, str]:
    missing = [each for each in expected if not any(exactly(each, other) for other in got)]
    extra = [each for each in got if not any(exactly(each, other) for other in expected)]
    right = f"{counted(len(expected), 'part')}, in any order"
    wrong = f"{len(got)}"
    if missing:
        right += f"; among them {shown(missing)}"
        wrong += "; those are missing"
    if extra:
        wrong += f"; {shown(extra)} should not be there"
    return right, wrong
