"""What was expected and what was got instead, in words: where two values part.

May import: the standard library, `bugbot.errors`, `grader.compare`, `performer.values`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable, Sequence
from functools import partial
from typing import Any

from bugbot.errors import counted, listed, times
from grader.compare import Compare, InAnyOrder, in_words, unordered
from performer.values import shown

__all__ = ["difference", "told_in_words"]

_LONG = 8
"""Rows of more parts than this are not shown whole, but where they differ."""

_MOST_NAMED = 3
"""So many parts are named; of the others only how many they are."""

_LONGEST_EXACT = 60


def difference(compare: Compare, expected: Any, got: Any) -> tuple[str, str]:
    """What was expected and what was got, in words that differ; of long rows, where they part.

    What was expected can stand behind "gives" or "has": "f() gives 19 as item 3".

    >>> from grader.compare import exactly
    >>> difference(exactly, list(range(20)), [*range(19), 7])
    ('19 as item 19 (counted from 0)', '7')
    """
    if isinstance(compare, in_words):
        told = told_in_words(compare, expected, got)
        return told or difference(compare.compare, expected, got)
    path: list[int] = []
    if _takes_any_order(compare, expected):
        return _of_any_order(compare, expected, got)
    fits: Fits = partial(_right, compare, expected)
    while (index := _first_apart(compare, fits, expected, got)) is not None:
        path.insert(0, index)
        fits = partial(_fits_at, fits, expected, index)
        expected, got = expected[index], got[index]
    right, wrong = _leaf(compare, expected, got)
    if right == wrong:
        right, wrong = f"{right} ({_exact(expected)})", f"{wrong} ({_exact(got)})"
    if right == wrong and isinstance(expected, str) and isinstance(got, str):
        right, wrong = _texts_apart(expected, got)
    if path:
        place = " of ".join(f"item {index}" for index in path)
        right = f"{right} as {place} (counted from 0)"
    return right, wrong


def told_in_words(compare: Compare, expected: Any, got: Any) -> tuple[str, str] | None:
    """What a check says itself of a wrong answer; None if it says nothing, or twice the same."""
    told = compare.apart(expected, got) if isinstance(compare, in_words) else None
    return told if told is not None and told[0] != told[1] else None


Fits = Callable[[Any], bool]
"""Whether the answer would be right with this part in it, and all else as expected."""


def _first_apart(compare: Compare, fits: Fits, expected: Any, got: Any) -> int | None:
    """The first part that differs, of two rows that are too long or too alike to be shown.

    A check's own way to compare is for entire answers: it is asked about those, never about a
    part by itself.
    """
    both_rows = all(isinstance(each, list | tuple) for each in (expected, got))
    if not both_rows or isinstance(compare, InAnyOrder) or len(expected) != len(got):
        return None
    if len(expected) <= _LONG and shown(expected) != shown(got):
        return None
    sound, wrong = 0, len(got)  # with so many of its parts the answer is right, and is not
    while wrong - sound > 1:
        half = (sound + wrong) // 2
        if fits([*got[:half], *expected[half:]]):
            sound = half
        else:
            wrong = half
    if not got or _fits_at(fits, expected, sound, got[sound]):
        return None  # it is not this part alone
    moved = [*expected[1:], *expected[:1]]
    if fits(moved) and not _fits_at(fits, expected, sound, moved[sound]):
        return None  # a sum, say: no part has a place where it must be
    return sound


def _fits_at(fits: Fits, expected: Any, index: int, part: Any) -> bool:
    return fits([*expected[:index], part, *expected[index + 1 :]])


def _takes_any_order(compare: Compare, expected: Any) -> bool:
    """Whether a check's own way to compare long rows of cells does not mind their order."""
    if isinstance(compare, InAnyOrder) or not isinstance(expected, list | tuple):
        return False
    if len(expected) <= _LONG or not all(isinstance(each, list | tuple) for each in expected):
        return False
    turned = expected[::-1]
    return turned != expected and _right(compare, expected, turned)


def _of_any_order(compare: Compare, expected: Any, got: Any) -> tuple[str, str]:
    if not isinstance(got, list | tuple | set | frozenset):
        return shown(expected), shown(got)
    one = "item"
    if _right(compare, expected, [*expected, expected[0]]):  # nor how often a part is there
        expected, got, one = _distinct(expected), _distinct(got), "different item"
    return _what_is_missing(expected, got, lambda part: unordered(part, 0), one)


def _right(compare: Compare, expected: Any, got: Any) -> bool:
    try:
        return compare(expected, got)
    except Exception:
        return False  # a check's own comparison need not be ready for this


def _distinct(parts: Any) -> list[Any]:
    return list({unordered(part, 0): part for part in parts}.values())


def _leaf(compare: Compare, expected: Any, got: Any) -> tuple[str, str]:
    both = (expected, got)
    are_sets = all(isinstance(each, set | frozenset) for each in both)
    are_rows = all(isinstance(each, list | tuple) for each in both)
    short = not (are_sets or are_rows) or max(map(len, both)) <= _LONG
    if short and shown(expected) != shown(got):
        return shown(expected), shown(got)
    if are_sets or (are_rows and isinstance(compare, InAnyOrder)):
        levels = compare.levels - 1 if isinstance(compare, InAnyOrder) else 0
        return _what_is_missing(expected, got, lambda part: unordered(part, levels))
    if are_rows and len(expected) != len(got):
        right, wrong = (f"{counted(len(each), 'item')}: {shown(each)}" for each in both)
        return right, wrong
    return shown(expected), shown(got)


def _what_is_missing(
    expected: Any, got: Any, key: Callable[[Any], Hashable], one: str = "item"
) -> tuple[str, str]:
    wanted, there = (Counter(map(key, each)) for each in (expected, got))
    parts = {key(each): each for each in (*expected, *got)}
    missing = [parts[each] for each in wanted if each not in there]
    extra = [parts[each] for each in there if each not in wanted]
    clauses = [f"{_named(missing)} missing"] if missing else []
    if extra:
        clauses.append(f"{_named(extra, verb=False)} should not be there")
    clauses += [
        f"{shown(parts[each])} is there {times(there[each])}, not {times(wanted[each])}"
        for each in list(wanted)
        if each in there and wanted[each] != there[each]
    ][:_MOST_NAMED]
    right = counted(len(expected), one)
    if len(expected) != 1:
        right += " in any order"
    wrong = counted(len(got), one) if got else f"an empty {type(got).__name__}"
    return right, f"{wrong}: {', and '.join(clauses)}" if clauses and got else wrong


def _named(parts: Sequence[Any], *, verb: bool = True) -> str:
    """A few parts by name, and how many more there are: "1, 2, 3 and 4 more are"."""
    texts = sorted(map(shown, parts))
    left_out = len(texts) - _MOST_NAMED
    if left_out > 1:
        texts = [*texts[:_MOST_NAMED], f"{left_out} more"]
    said = listed(texts)
    if not verb:
        return said
    return f"{said} {'is' if len(parts) == 1 else 'are'}"


def _texts_apart(expected: str, got: str) -> tuple[str, str]:
    """Two long texts that begin alike, from a little before the place where they part."""
    apart = (n for n, (a, b) in enumerate(zip(expected, got, strict=False)) if a != b)
    alike = next(apart, min(len(expected), len(got)))
    begin = max(0, alike - 10)
    both = (shown(each[begin:][:_LONGEST_EXACT]) for each in (expected, got))
    right, wrong = (f"{text} from character {begin}" for text in both)
    return right, wrong


def _exact(value: Any) -> str:
    """A value with its type and all its digits, for two that look alike."""
    text = repr(value)
    cut = text if len(text) <= _LONGEST_EXACT else f"{text[: _LONGEST_EXACT - 1]}…"
    return f"the {type(value).__name__} {cut}"
