"""How answers are compared, and how a difference is put into words."""

from __future__ import annotations

from math import inf, nan
from typing import Any

import pytest

from grader.compare import Compare, difference, exactly, in_any_order, near
from grader.failures import AuthorError
from performer.values import Other


@pytest.mark.parametrize(
    ("compare", "expected", "got", "right"),
    [
        (exactly, (2, 1), [2, 1], True),
        (exactly, (2, 1), (2.0, 1.0), False),
        (exactly, 1, True, False),
        (exactly, True, True, True),
        (exactly, True, 1, False),
        (exactly, 0.3, 0.1 + 0.2, True),
        (exactly, nan, nan, True),
        (exactly, None, None, True),
        (exactly, None, 0, False),
        (exactly, "a", "a", True),
        (exactly, [1, 2], [1], False),
        (exactly, {"a": 0.3}, {"a": 0.1 + 0.2}, True),
        (exactly, {"a": 1}, {"b": 1}, False),
        (exactly, {1, 2}, {2, 1}, True),
        (exactly, {1}, {1.5}, False),
        (exactly, [1], {1}, False),
        (exactly, Other("a map"), Other("a map"), False),
        (exactly, 0.0, 1e-10, True),
        (exactly, 1.0, 1.5, False),
        (exactly, 1.0, nan, False),
        (exactly, {"a": 1}, [1], False),
        (near(0.5), 10, 10.4, True),
        (near(0.5), 10, 10.6, False),
        (near(0.5), 10, 10.5, True),
        (near(0.5), (1, [2.0]), [1.2, (2,)], True),
        (near(0.5), inf, inf, True),
        (near(0.5), 1.0, nan, False),
        (near(0.5), 1, True, False),
        (near(0.5), None, 0.0, False),
        (in_any_order, [1, 2, 2], (2, 1, 2), True),
        (in_any_order, [1, 2, 2], [2, 1, 1], False),
        (in_any_order, {(1, 2)}, [[1, 2]], True),
        (in_any_order, [(1, 2)], [(2, 1)], False),
        (in_any_order, [[1, 2], [3]], [[3], [2, 1]], False),
        (in_any_order, [0.3, {"a": 1}], [{"a": 1}, 0.1 + 0.2], True),
        (in_any_order.deep(2), [[1, 2], [3]], [{3}, [2, 1]], True),
        (in_any_order, [1], [Other("a map")], False),
        (in_any_order, [{1, 2}], [{2, 1}], True),
        (in_any_order, 1, 1, True),
        (in_any_order, [True], [1], False),
        (in_any_order, [[1, 2]], [(1, 2)], True),
        (in_any_order, [[1, [2, 3]]], [[1, [3, 2]]], False),
        (in_any_order, [{1, 2}], [{1, 3}], False),
        (in_any_order, [{(1, 2)}], [{(2, 1)}], False),
        (in_any_order, [{"a": 1}], [{"a": 2}], False),
        (in_any_order, [{"a": [1, 2]}], [{"a": [2, 1]}], False),
        (in_any_order, [1.25], [1.3], False),
        (in_any_order, [0.1234567891], [0.1234567893], True),
        (in_any_order, [Other("a map")], [Other("a map")], False),
    ],
)
def test_comparing(compare: Compare, expected: Any, got: Any, right: bool) -> None:
    assert compare(expected, got) is right


def test_near_wants_a_number() -> None:
    with pytest.raises(AuthorError, match="wants a number for within; it got 'cm'"):
        near("cm")  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("compare", "expected", "got", "words"),
    [
        (exactly, (2, 1), None, ("(2, 1)", "None")),
        (
            exactly,
            [0] * 8,
            [0] * 7 + [1],
            ("[0, 0, 0, 0, 0, 0, 0, 0]", "[0, 0, 0, 0, 0, 0, 0, 1]"),
        ),
        (exactly, [0] * 9, [0] * 8 + [1], ("item 8 (counted from 0) is 0", "it is 1")),
        (exactly, [0] * 9, [0], ("9 items: [0] * 9", "1 item: [0]")),
        (exactly, [0] * 9, [0] * 10, ("9 items: [0] * 9", "10 items: [0] * 10")),
        (
            in_any_order,
            list(range(9)),
            [*range(1, 9), 20],
            (
                "9 parts, in any order; among them [0]",
                "9; those are missing; [20] should not be there",
            ),
        ),
        (
            in_any_order,
            list(range(9)),
            list(range(8)),
            ("9 parts, in any order; among them [8]", "8; those are missing"),
        ),
    ],
)
def test_a_difference_in_words(
    compare: Compare, expected: Any, got: Any, words: tuple[str, str]
) -> None:
    assert difference(compare, expected, got) == words


def test_what_differs_only_as_a_whole_is_shown_as_a_whole() -> None:
    def sums(expected: Any, got: Any) -> bool:
        return isinstance(expected, int) or sum(expected) == sum(got)

    words = difference(sums, list(range(9)), list(range(1, 10)))
    assert words == (
        "[0, 1, 2, 3, 4, 5, 6, 7, … 1 more]",
        "[1, 2, 3, 4, 5, 6, 7, 8, … 1 more]",
    )
