"""How answers are compared, and how a difference is put into words."""

from __future__ import annotations

from math import inf, nan
from typing import Any

import pytest

from grader.compare import Compare, exactly, in_any_order, in_words, near
from grader.difference import difference
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


NINE = "9 items in any order"


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
        (exactly, [0] * 9, [0] * 8 + [1], ("0 as item 8 (counted from 0)", "1")),
        (exactly, [0] * 9, [0], ("9 items: [0] * 9", "1 item: [0]")),
        (exactly, [0] * 9, [0] * 10, ("9 items: [0] * 9", "10 items: [0] * 10")),
        (exactly, [0] * 9, [], ("9 items: [0] * 9", "0 items: []")),
        (
            exactly,
            [[0] * 9] * 9,
            [[0] * 9] * 8 + [[0] * 8 + [4]],
            ("0 as item 8 of item 8 (counted from 0)", "4"),
        ),
        (exactly, 2, 2.0, ("2", "2.0")),
        (exactly, 0.3, 0.3000001, ("0.3 (the float 0.3)", "0.3 (the float 0.3000001)")),
        (exactly, {1, 2}, {1}, ("{1, 2}", "{1}")),
        (exactly, {(1, 2)}, {(2, 1)}, ("{(1, 2)}", "{(2, 1)}")),
        (exactly, set(range(9)), set(), (NINE, "an empty set")),
        (
            exactly,
            {1},
            set(range(9)),
            ("1 item", "9 items: 0, 2, 3 and 5 more should not be there"),
        ),
        (
            exactly,
            set(),
            set(range(9)),
            ("0 items in any order", "9 items: 0, 1, 2 and 6 more should not be there"),
        ),
        (exactly, set(range(9)), set(range(8)), (NINE, "8 items: 8 is missing")),
        (exactly, set(range(9)), set(range(10)), (NINE, "10 items: 9 should not be there")),
        (exactly, set(range(9)), set(range(7)), (NINE, "7 items: 7 and 8 are missing")),
        (exactly, set(range(9)), set(range(5)), (NINE, "5 items: 5, 6, 7 and 8 are missing")),
        (
            exactly,
            set(range(9)),
            set(range(4)),
            (NINE, "4 items: 4, 5, 6 and 2 more are missing"),
        ),
        (
            in_any_order,
            list(range(9)),
            [*range(1, 9), 20],
            (NINE, "9 items: 0 is missing, and 20 should not be there"),
        ),
        (
            in_any_order,
            [0, *range(8)],
            [*range(8), 7],
            (NINE, "9 items: 0 is there once, not twice, and 7 is there twice, not once"),
        ),
        (
            in_any_order.deep(2),
            [[n, 0] for n in range(9)],
            [[0, n] for n in range(8)],
            (NINE, "8 items: [8, 0] is missing"),
        ),
    ],
)
def test_a_difference_in_words(
    compare: Compare, expected: Any, got: Any, words: tuple[str, str]
) -> None:
    assert difference(compare, expected, got) == words
    assert words[0] != words[1]


def cells_in_any_order(expected: Any, got: Any) -> bool:
    return {tuple(cell) for cell in expected} == {tuple(cell) for cell in got}


def test_a_comparison_that_minds_no_order_is_told_what_is_missing() -> None:
    cells = [(column, 3) for column in range(9) for _ in range(2)]
    for got, told in (
        (cells[2:], "8 different items: (0, 3) is missing"),
        ({(9, 3), *cells}, "10 different items: (9, 3) should not be there"),
        (
            [[9, 3], *cells[2:]],
            "9 different items: (0, 3) is missing, and [9, 3] should not be there",
        ),
        ([], "an empty list"),
        (None, "None"),
    ):
        assert difference(cells_in_any_order, cells, got)[1] == told
    assert difference(cells_in_any_order, cells, [])[0] == "9 different items in any order"
    counted_too = in_any_order.deep(1)
    assert difference(lambda a, b: counted_too(a, b), cells, cells[1:]) == (
        "18 items in any order",
        "17 items: (0, 3) is there once, not twice",
    )


def sums_in_words(expected: Any, got: Any) -> tuple[str, str] | None:
    if not isinstance(got, list):
        return None
    return f"numbers that make {sum(expected)}", f"{sum(got)}"


def test_where_several_answers_are_right_the_check_says_what_is_wanted() -> None:
    compare = in_words(lambda a, b: isinstance(b, list) and sum(a) == sum(b), sums_in_words)
    assert compare([1, 5], [2, 4])
    assert not compare([1, 5], [2, 5])
    assert difference(compare, [1, 5], [2, 5]) == ("numbers that make 6", "7")
    assert difference(compare, [1, 5], 7) == ("[1, 5]", "7")
    alike = in_words(exactly, lambda a, b: ("a number", "a number"))
    assert difference(alike, 3, 4) == ("3", "4")
    with pytest.raises(AuthorError, match="two functions"):
        in_words(exactly, "a text")  # type: ignore[arg-type]


def test_what_differs_only_as_a_whole_is_shown_as_a_whole() -> None:
    def sums(expected: Any, got: Any) -> bool:
        return isinstance(expected, int) or sum(expected) == sum(got)

    words = difference(sums, list(range(9)), list(range(1, 10)))
    assert words == (
        "[0, 1, 2, 3, 4, 5, 6, 7, … 1 more]",
        "[1, 2, 3, 4, 5, 6, 7, 8, … 1 more]",
    )


def headings_in_any_turn(expected: Any, got: Any) -> bool:
    """A check's own comparison, which can be asked about entire answers only."""
    return len(expected) == len(got) and all(
        abs(a[0] - b[0]) < 0.05 and (a[1] - b[1] + 0.01) % 360 < 0.02
        for a, b in zip(expected, got, strict=True)
    )


def test_of_long_answers_the_first_part_beyond_the_tolerance_is_named() -> None:
    right = [(3.0 + n, 10.0 * n) for n in range(12)]
    close = [(x + 0.01, heading - 360) for x, heading in right]
    close[7] = (close[7][0], 75.0)
    assert difference(headings_in_any_turn, right, close) == (
        "(10.0, 70.0) as item 7 (counted from 0)",
        "(10.01, 75.0)",
    )


def test_two_wrong_parts_of_which_the_second_is_the_worse_are_told_by_the_first() -> None:
    right = list(range(100))
    got = [*right[:40], 41, *right[41:98], -500, 99]
    assert difference(exactly, right, got) == ("40 as item 40 (counted from 0)", "41")


def test_long_texts_are_shown_where_they_part() -> None:
    right, wrong = "a" * 90 + "b", "a" * 90 + "c"
    assert difference(exactly, right, wrong) == (
        "'aaaaaaaaaab' from character 80",
        "'aaaaaaaaaac' from character 80",
    )
