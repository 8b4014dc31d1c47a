"""Slips with values: indices, kinds that do not mix, too much of something.

May import: the standard library, `bugbot.errors`, the rest of `bugbot.run.slips`.
"""

from __future__ import annotations

import re

from bugbot.errors import BugbotError
from bugbot.run.slips.case import Case, Slip

__all__ = ["SLIPS"]


def _index_out_of_range(case: Case) -> str | None:
    if not isinstance(case.error, IndexError):
        return None
    if case.message.startswith("pop from"):
        return "There is nothing left in it: ask first, for example with while queue:"
    axis = re.search(r"is out of bounds for axis (\d) with size (\d+)", case.message)
    if axis:
        return (
            f"Along axis {axis[1]} the indices go from 0 to {int(axis[2]) - 1}. In "
            "grid[row, column] axis 0 is the row, and a point off the mat has no cell."
        )
    many = re.search(r"array is (\d)-dimensional, but (\d)", case.message)
    if many:
        return f"The array has {_counted(many[1], 'axis', 'axes')}, and here it is given {many[2]}."
    if not re.search(r"index out of range|assignment index", case.message):
        return None
    sizes = [
        _size(name, value)
        for name in dict.fromkeys(re.findall(r"\b([A-Za-z_]\w*)\s*\[", case.code))
        if isinstance(value := case.scope.get(name), list | tuple | str)
    ]
    hint = "The first index is 0."
    if re.search(r"\[[^\]]*\*[^\]]*\+[^\]]*\]|\[[^\]]*\+[^\]]*\*[^\]]*\]", case.code):
        hint += (
            " In a grid kept as one list, the cell (column, row) has the index row * columns + "
            "column, and a point off the mat has no cell."
        )
    return " ".join([*sizes, hint])


def _size(name: str, value: list[object] | tuple[object, ...] | str) -> str:
    if not value:
        return f"{name} is empty."
    parts = ("character", "characters") if isinstance(value, str) else ("item", "items")
    last = f", with the indices 0 to {len(value) - 1}" if len(value) > 1 else ""
    return f"{name} has {_counted(str(len(value)), *parts)}{last}."


def _counted(number: str, one: str, many: str) -> str:
    return f"{number} {one if number == '1' else many}"


def _float_index(case: Case) -> str | None:
    if case.message.startswith("only integers, slices"):
        return (
            "An index of an array is a whole number: use // to divide, or int(…) or math.floor(…) "
            "round it."
        )
    if re.search(r"indices must be integers.* not '?float|slice indices must be", case.message):
        return "An index is a whole number: use // to divide, or int(…) round it."
    if re.search(
        r"'float' object cannot be interpreted as an integer|sequence of integers or a single int"
        r"|multiply sequence by non-int of type 'float'|^non-integer (arg|stop|start)",
        case.message,
    ):
        return "A whole number is wanted here: use // to divide, or int(…) round it."
    return None


def _pair_index(case: Case) -> str | None:
    if re.search(r"indices must be integers.* not '?tuple", case.message):
        return "A list of lists wants grid[row][column]; grid[row, column] is for NumPy's arrays."
    if "Cannot interpret" in case.message and re.search(r"\b(zeros|ones|empty)\s*\(", case.code):
        return "The size of an array stands in brackets of its own: np.zeros((rows, columns))"
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
    if "can only concatenate tuple" in case.message:
        return "One side is a tuple, several values at once. With a comma, 3,5 is one as well: 3.5"
    if "multiply sequence by non-int" in case.message:
        return "A text or a list can only be repeated: take its numbers one by one, or use NumPy."
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


def _single_point(case: Case) -> str | None:
    """`draw("goal", (100, 150))`: a point where a list of points is wanted."""
    if isinstance(case.error, BugbotError) and re.search(
        r"points for points; it got -?[\d.]+$", case.message
    ):
        return 'A point is a pair, and draw() wants a list of them: draw("goal", [(100, 150)])'
    if isinstance(case.error, BugbotError) and "in each point; point number 0 is" in case.message:
        if re.search(r"number 0 is -?[\d.]+$", case.message):
            return "A single point needs square brackets round it as well: [(x, y)]"
        return "Every point is a pair in brackets, in cm on the mat: [(100, 150), (105, 150)]"
    return None


def _conversion(case: Case) -> str | None:
    found = re.match(
        r"(?:invalid literal for int.*|could not convert string to float): (['\"])(.*)\1",
        case.message,
        re.DOTALL,
    )
    if not found:
        return None
    if not found[2].strip():
        return "The text is empty."
    if re.fullmatch(r"\s*[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?\s*", found[2]):
        return "int() reads whole numbers only: float(…) reads this one, and int(float(…)) cuts it."
    return "The text holds something else than a number."


def _not_hashable(case: Case) -> str | None:
    found = re.match(r"(?:.*)unhashable type: '(list|set|dict)'", case.message)
    if not found:
        return None
    instead = {"list": "a tuple, (1, 2)", "set": "frozenset(…)", "dict": "a tuple of its values"}
    return f"A {found[1]} can't be in a set or be a key: use {instead[found[1]]}."


def _several_compared(case: Case) -> str | None:
    """`scan()[0] < 20`: a pair is compared with a number."""
    kinds = re.search(r"between instances of '(\w+)' and '(\w+)'", case.message)
    if not kinds or not {"int", "float"} & set(kinds.groups()):
        return None
    for kind in kinds.groups():
        if kind in ("tuple", "list"):
            return f"One side is a {kind}, several values at once: take one of them, like pair[1]."
    return None


def _shapes(case: Case) -> str | None:
    if "could not be broadcast together" in case.message:
        return "The two arrays differ in size: print the shape of each, like a.shape."
    if re.search(r"Field elements must be|data type .* not understood", case.message):
        return "The rows of an array are a list of lists: np.array([[1, 2], [3, 4]])"
    return None


def _changed_while_looping(case: Case) -> str | None:
    if "changed size during iteration" in case.message:
        return "A loop must not add to or take from what it goes through: go through list(…) of it."
    return None


def _memory(case: Case) -> str | None:
    too_large = isinstance(case.error, OverflowError) and "index-sized" in case.message
    if isinstance(case.error, MemoryError) or too_large:
        return "Does a list or a text grow without end?"
    return None


SLIPS: tuple[Slip, ...] = (
    _memory,
    _float_index,
    _index_out_of_range,
    _pair_index,
    _text_and_number,
    _not_a_list,
    _single_point,
    _conversion,
    _not_hashable,
    _several_compared,
    _shapes,
    _changed_while_looping,
)
