"""Slips with values: indices, kinds that do not mix, arithmetic without an answer.

May import: the standard library, `bugbot.errors`, the rest of `bugbot.run.slips`.
"""

from __future__ import annotations

import re

from bugbot.errors import BugbotError, nearest
from bugbot.run.slips.case import Case, Slip

__all__ = ["SLIPS"]


def _index_out_of_range(case: Case) -> str | None:
    if not isinstance(case.error, IndexError):
        return None
    hint = (
        "The first has number 0. In a grid kept as one list, the cell (column, row) is number "
        "row * columns + column, and a point beyond the mat has no cell."
    )
    sizes = [
        f"{name} has {len(value)}, with the numbers 0 to {len(value) - 1}."
        for name in dict.fromkeys(re.findall(r"\b([A-Za-z_]\w*)\s*\[", case.code))
        if isinstance(value := case.scope.get(name), list | tuple | str)
    ]
    return " ".join([*sizes, hint])


def _float_index(case: Case) -> str | None:
    if re.search(r"indices must be integers.* not '?float|slice indices must be", case.message):
        return "An index is a whole number: use // to divide, or int(…) round it."
    if re.search(r"'float' object cannot be interpreted as an integer", case.message):
        return "A whole number is wanted here: use // to divide, or int(…) round it."
    return None


def _pair_index(case: Case) -> str | None:
    if re.search(r"indices must be integers.* not '?tuple", case.message):
        return "A list of lists wants grid[row][column]; grid[row, column] is for NumPy's arrays."
    if re.search(r"indices must be integers.* not '?str", case.message):
        return "A list is asked by number, a dictionary by name."
    return None


def _text_and_number(case: Case) -> str | None:
    message = case.message
    joined = re.search(r"can only concatenate str|must be str, not", message)
    mixed = re.search(r"operand.*'(int|float)' and 'str'|operand.*'str' and '(int|float)'", message)
    compared = re.search(
        r"not supported between instances of '(str' and '(int|float)|(int|float)' and 'str)'",
        message,
    )
    if compared or mixed:
        return (
            "One side is a text, the other a number: int(…) or float(…) makes a number of a text."
        )
    if joined:
        return "A text and a number can't be added: print(a, b) takes both, or use f'{a} {b}'."
    return None


def _not_a_list(case: Case) -> str | None:
    found = re.match(r"'(int|float)' object is not (iterable|subscriptable)", case.message)
    if found and found[2] == "iterable":
        return "This is a single number, not a list. To count up to it: for i in range(…):"
    if found:
        return "This is a single number: it has no parts to ask for with [ ]."
    if re.match(r"object of type '(int|float)' has no len", case.message):
        return "This is a single number, not a list."
    return None


def _division(case: Case) -> str | None:
    if isinstance(case.error, ZeroDivisionError):
        return "What stands under the division is 0 here: ask with if before dividing."
    return None


def _no_answer(case: Case) -> str | None:
    if isinstance(case.error, OverflowError):
        return "The number gets too large. exp() of more than 709 does: clamp what goes into it."
    found = re.search(
        r"math domain error|expected a (positive|nonnegative) (input|number)", case.message
    )
    if isinstance(case.error, ValueError) and (found or "range from" in case.message):
        return (
            "log() wants more than 0, sqrt() 0 or more, asin() and acos() -1 to 1. With "
            "probabilities: p must not be 0 or 1."
        )
    return None


def _not_a_number(case: Case) -> str | None:
    if isinstance(case.error, BugbotError) and re.search(
        r"(it|\d) (got|is) .*\b(nan|inf)\b", case.message
    ):
        return (
            "nan and inf come from sums without an answer, like inf - inf: look where it came in."
        )
    return None


def _single_point(case: Case) -> str | None:
    """`draw("goal", (100, 150))`: a point where a list of points is wanted."""
    if isinstance(case.error, BugbotError) and "in each point; point number 0 is" in case.message:
        if re.search(r"number 0 is -?[\d.]+$", case.message):
            return "A single point needs square brackets round it as well: [(x, y)]"
        return "Every point is a pair in brackets, in cm on the mat: [(100, 150), (105, 150)]"
    return None


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
        return f"Did you mean {near!r}?"
    return "Ask first with: if key in table: … or take a default: table.get(key, 0)"


def _conversion(case: Case) -> str | None:
    if re.match(r"invalid literal for int|could not convert string to float", case.message):
        return "The text holds something else than a number."
    return None


def _changed_while_looping(case: Case) -> str | None:
    if "changed size during iteration" in case.message:
        return "A loop must not add to or take from what it goes through: go through list(…) of it."
    return None


def _array_truth(case: Case) -> str | None:
    if "truth value of an array" in case.message:
        return "An array has many answers: ask with (…).any() or (…).all()"
    return None


def _memory(case: Case) -> str | None:
    too_large = isinstance(case.error, OverflowError) and "index-sized" in case.message
    if isinstance(case.error, MemoryError) or too_large:
        return "Does a list or a text grow without end?"
    return None


SLIPS: tuple[Slip, ...] = (
    _memory,
    _index_out_of_range,
    _float_index,
    _pair_index,
    _text_and_number,
    _not_a_list,
    _division,
    _no_answer,
    _not_a_number,
    _single_point,
    _key,
    _conversion,
    _changed_while_looping,
    _array_truth,
)
