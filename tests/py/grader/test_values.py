"""Values cross between program and judge by their exact type, whatever they say of themselves."""

from __future__ import annotations

import json
from array import array
from collections import Counter, OrderedDict, deque, namedtuple
from collections.abc import Callable
from decimal import Decimal
from enum import IntEnum
from fractions import Fraction
from math import inf, isnan, nan
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from performer.values import DecimalFloat, MalformedError, Other, decoded, encoded, shown


class Colour(IntEnum):
    RED = 1


Point = namedtuple("Point", "x y")

PLAIN = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(),
    lambda inner: st.lists(inner) | st.tuples(inner, inner) | st.dictionaries(st.text(), inner),
    max_leaves=20,
)


@given(PLAIN)
def test_plain_values_come_through_json_as_they_were(value: object) -> None:
    again = decoded(json.loads(json.dumps(encoded(value))))
    assert again == value
    assert repr(again) == repr(value)


@pytest.mark.parametrize(
    ("value", "plain"),
    [
        (Colour.RED, 1),
        (Point(1, 2.0), (1, 2.0)),
        (Counter("aab"), {"a": 2, "b": 1}),
        (OrderedDict(a=1), {"a": 1}),
        (deque([1, 2]), [1, 2]),
        (frozenset({1}), {1}),
        ({(1, 2), (3, 4)}, {(1, 2), (3, 4)}),
        ({frozenset({1})}, {frozenset({1})}),
        (np.int64(3), 3),
        (np.float32(0.5), 0.5),
        (np.array([[1, 2], [3, 4]]), [[1, 2], [3, 4]]),
        (10**30, 10**30),
        (inf, inf),
        ([0.5, 1.5], [0.5, 1.5]),
        ([0.5, inf], [0.5, inf]),
    ],
)
def test_kinds_of_plain_values_become_plain(value: object, plain: object) -> None:
    again = decoded(encoded(value))
    assert again == plain
    assert type(again) is type(plain)


def test_nan_stays_one() -> None:
    assert isnan(decoded(encoded(nan)))


def test_a_float_survives_a_language_with_one_kind_of_number() -> None:
    assert type(decoded(encoded(2.0))) is float
    assert decoded(2.0) == 2
    assert type(decoded(2.0)) is int  # JSON's 2 that has become 2.0


@pytest.mark.parametrize(
    ("value", "what"),
    [
        (print, "a builtin_function_or_method"),
        (object(), "an object"),
        (iter([]), "a list_iterator"),
        (type("X" * 100, (), {})(), f"an {'X' * 60}"),
        ([0] * 100_000, "a list of more than 50000 parts, or 12 deep"),
    ],
)
def test_what_is_no_plain_value_says_what_it_was(value: object, what: str) -> None:
    other = decoded(encoded(value))
    assert isinstance(other, Other)
    assert shown(other) == what


def test_a_value_without_end_is_cut_off() -> None:
    endless: list[object] = []
    endless.append(endless)
    for value in (endless, list(range(100_000)), [[0.5] * 40_000, [0.5] * 40_000]):
        assert isinstance(decoded(encoded(value)), Other)


def nested(kind: Callable[[list[Any]], Any], deep: int) -> Any:
    """An empty text in so many boxes."""
    value: Any = ""
    for _ in range(deep):
        value = kind([value])
    return value


@pytest.mark.parametrize(
    "kind",
    [list, deque, tuple, frozenset, lambda each: {1: each[0]}],
    ids=["list", "deque", "tuple", "set", "dict"],
)
def test_a_value_may_be_twelve_deep(kind: Callable[[list[Any]], Any]) -> None:
    assert not isinstance(decoded(encoded(nested(kind, 12))), Other)
    assert isinstance(decoded(encoded(nested(kind, 13))), Other)


def test_a_set_of_a_program_may_be_deep_as_well() -> None:
    assert encoded({1}) == {"set": [1]}
    assert isinstance(decoded(encoded({nested(frozenset, 12)})), Other)


def test_a_value_may_have_fifty_thousand_parts() -> None:
    assert encoded(["a"] * 49_999) == ["a"] * 49_999
    assert isinstance(decoded(encoded(["a"] * 50_000)), Other)
    assert encoded([0.5] * 49_999) == {"floats": [0.5] * 49_999}
    assert isinstance(decoded(encoded([0.5] * 50_000)), Other)


@pytest.mark.parametrize(
    ("number", "code"),
    [
        (5, 5),
        (2**53 - 1, 2**53 - 1),
        (-(2**53) + 1, -(2**53) + 1),
        (2**53, {"int": "0x20000000000000"}),
        (-(2**53), {"int": "-0x20000000000000"}),
    ],
)
def test_an_integer_beyond_what_json_holds_is_written_out(number: int, code: object) -> None:
    assert encoded(number) == code


def test_what_is_told_of_another_value_is_short() -> None:
    assert shown(decoded({"other": "x" * 300})) == "x" * 200


def test_a_refusal_names_the_tag() -> None:
    with pytest.raises(MalformedError, match="no such tag: what"):
        decoded({"what": 1})


@pytest.mark.parametrize(
    "data",
    [
        {},
        {"float": "x"},
        {"what": 1},
        {"a": 1, "b": 2},
        {"dict": [1]},
        {"int": []},
        {"floats": ["a"]},
        inf,
    ],
)
def test_what_encoding_never_makes_is_refused(data: object) -> None:
    with pytest.raises(MalformedError):
        decoded(data)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (1 / 3, "0.333333"),
        (-0.0, "0.0"),
        ((1,), "(1,)"),
        ([0.0] * 1600, "[0.0] * 1600"),
        (list(range(100)), "a list of 100 numbers"),
        (list(range(10)), "[0, 1, 2, 3, 4, 5, 6, 7, … 2 more]"),
        ({3, 1}, "{1, 3}"),
        (set(), "set()"),
        ({"a": [1]}, "{'a': [1]}"),
        ({"a": 1, "b": 2}, "{'a': 1, 'b': 2}"),
        ({1, "a"}, "{'a', 1}"),
        (["a"] * 8, "['a', 'a', 'a', 'a', 'a', 'a', 'a', 'a']"),
        (["a"] * 9, "['a', 'a', 'a', 'a', 'a', 'a', 'a', 'a', … 1 more]"),
        (list(range(24)), "[0, 1, 2, 3, 4, 5, 6, 7, … 16 more]"),
        ("x" * 58, repr("x" * 58)),
        (10**59, "1" + "0" * 59),
        ("x" * 100, "'" + "x" * 58 + "…"),
        (10**100, "1" + "0" * 58 + "…"),
        (None, "None"),
    ],
)
def test_values_are_shown_short(value: object, text: str) -> None:
    assert shown(value) == text


@pytest.mark.parametrize(
    ("value", "arrives"),
    [
        (Fraction(10, 2), 5),
        (Fraction(1, 2), 0.5),
        (Decimal("5.0"), DecimalFloat(5.0)),
        (range(3), [0, 1, 2]),
        (bytes([0, 205, 254]), [0, 205, 254]),
        (bytearray(2), [0, 0]),
        (array("B", [205]), [205]),
        ({(1, frozenset([2])): 3}, {(1, frozenset([2])): 3}),
    ],
)
def test_numbers_and_keys_by_other_names_mean_what_they_say(value: object, arrives: object) -> None:
    there = decoded(encoded(value))
    assert there == arrives
    assert type(there) is type(arrives)


def test_a_number_too_long_to_be_shown_is_described() -> None:
    huge = decoded(encoded(10**200_000))
    assert isinstance(huge, Other)
    assert huge.what == "a whole number of some 199,315 digits"


def test_what_was_sent_is_not_changed_by_what_happens_later() -> None:
    """A list that a program goes on changing: each look at it keeps what was there then."""
    for values in ([1.0, 2.0], [1, 2], [[1.0], [2.0]]):
        sent = encoded(values)
        before = decoded(sent)
        values.clear()
        assert decoded(sent) == before
