"""How an answer is compared with what is right; `grader.difference` puts it into words.

May import: the standard library, `grader.failures`, `performer.values`.

Lists and tuples count as the same everywhere: a learner who answers [2, 1] for (2, 1) has
understood. True and False are no numbers.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable
from dataclasses import dataclass
from math import isclose, isnan
from typing import Any

from grader.failures import AuthorError
from performer.values import Other

__all__ = [
    "Apart",
    "Between",
    "Compare",
    "InAnyOrder",
    "between",
    "exactly",
    "in_any_order",
    "in_words",
    "near",
    "unordered",
]

Compare = Callable[[Any, Any], bool]
"""compare(expected, got): whether the answer is right."""

Apart = Callable[[Any, Any], tuple[str, str] | None]
"""apart(expected, got): both in words where the answer is wrong; None if it has none for it."""

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
class InAnyOrder:
    """The same parts, whatever their order so many levels down."""

    levels: int = 1

    def __call__(self, expected: Any, got: Any) -> bool:
        """Whether the answer is right."""
        return unordered(expected, self.levels) == unordered(got, self.levels)

    def deep(self, levels: int) -> InAnyOrder:
        """The order inside the parts does not matter either, so many levels down."""
        return InAnyOrder(levels)


in_any_order = InAnyOrder()
"""The same parts as often as there, in any order; `in_any_order.deep(2)`: inside them as well."""


@dataclass(frozen=True, slots=True)
class in_words:  # noqa: N801 - a word of the vocabulary
    """As `compare` says, and what is expected in words, where one of several answers is shown.

    Where many answers are right, the reference's own is only one of them: naming its parts would
    ask for more than the task does.

    apart  (expected, got) -> what the learner reads behind "gives" and as what it gave instead:
           ("a route 5 long", "one 6 long"); None where the values themselves should be shown

    >>> longest = in_words(lambda a, b: max(a) == max(b), lambda a, b: (f"up to {max(a)}", str(b)))
    >>> longest([3, 5], [5]), longest.apart([3, 5], [4])
    (True, ('up to 5', '[4]'))
    """

    compare: Compare
    apart: Apart

    def __post_init__(self) -> None:
        if not (callable(self.compare) and callable(self.apart)):
            raise AuthorError("in_words(compare, apart) wants two functions of (expected, got)")

    def __call__(self, expected: Any, got: Any) -> bool:
        """Whether the answer is right."""
        return self.compare(expected, got)


@dataclass(frozen=True, slots=True, repr=False)
class Between:
    """Stands in an expectation for any number from `low` to `high`."""

    low: float
    high: float
    said: str

    def __repr__(self) -> str:
        """As the learner reads it."""
        return self.said

    def holds(self, got: object) -> bool:
        """Whether the answer is such a number."""
        return isinstance(got, int | float) and _is_number(got) and self.low <= got <= self.high


def between(low: float, high: float, said: str = "") -> Between:
    """Any number from `low` to `high`, wherever it stands in what a check expects.

    said  what the learner reads in its place: "0 or less"

    >>> exactly([between(-1, 0), 2], [-0.4, 2])
    True
    """
    return Between(low, high, said or f"a number from {low:g} to {high:g}")


def _same(expected: Any, got: Any, alike: _Numbers) -> bool:
    if isinstance(expected, Between):
        return expected.holds(got)
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


def unordered(value: Any, levels: int) -> Hashable:
    """The value as a key that is equal for equal values, whatever their order so many levels."""
    if levels and isinstance(value, list | tuple | set | frozenset):
        return "parts", frozenset(Counter(unordered(each, levels - 1) for each in value).items())
    if isinstance(value, list | tuple):
        return "row", tuple(unordered(each, 0) for each in value)
    if isinstance(value, set | frozenset):
        return "parts", frozenset((unordered(each, 0), 1) for each in value)
    if isinstance(value, dict):
        return "dict", frozenset((key, unordered(each, 0)) for key, each in value.items())
    if isinstance(value, float):
        return "float", round(value, 9)
    if isinstance(value, Other):
        return "other", id(value)
    return type(value).__name__, value
