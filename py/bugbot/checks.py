"""Checks of the arguments of the robot's calls, and the sentences for the wrong ones.

May import: the standard library, `bugbot.errors`, `bugbot.colours`, `bugbot.trace`.

Each check takes the call as the help writes it, the argument's name and the value,
and returns the value in the form the rest of bugbot works with. True and False are
not numbers here, and neither are NaN and infinity.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from decimal import Decimal
from itertools import chain
from math import inf, isfinite
from numbers import Real
from typing import Any, NoReturn

from bugbot.colours import COLOURS
from bugbot.errors import WrongTypeError, WrongValueError, got, nearest
from bugbot.trace import storable

__all__ = ["choice", "colour", "name", "number", "points", "rgb"]

_NAME_LENGTH = 100
"""A layer's or line's name is shown in a legend; longer ones are refused [characters]."""

_NUMBERS = (Real, Decimal)
"""Fractions are real numbers by Python's own account, Decimals are not."""

_HEX_DIGITS = frozenset("0123456789abcdef")


def number(
    call: str, argument: str, value: Any, wants: str, low: float = -inf, high: float = inf
) -> float:
    """A number from `low` to `high`; NumPy's are welcome."""
    kind = type(value)
    if kind is not float and kind is not int and (kind is bool or not isinstance(value, _NUMBERS)):
        _refuse(WrongTypeError, call, argument, wants, value)
    try:
        figure = float(value)
    except (OverflowError, ValueError):  # an int of hundreds of digits, a signalling NaN
        figure = inf
    if not (low <= figure <= high and isfinite(figure)):
        _refuse(WrongValueError, call, argument, wants, value)
    return figure


def name(call: str, value: Any) -> str:
    """The name of a layer or of a line of the chart."""
    wants = f"a name in quotes, of 1 to {_NAME_LENGTH} characters,"
    if not isinstance(value, str):
        _refuse(WrongTypeError, call, "name", wants, value)
    if not 1 <= len(value) <= _NAME_LENGTH:
        _refuse(WrongValueError, call, "name", wants, value)
    return storable(value)


def choice(call: str, argument: str, value: Any, known: Sequence[str]) -> str:
    """One of a few words."""
    wants = f"one of {', '.join(map(repr, known))}"
    if not isinstance(value, str):
        _refuse(WrongTypeError, call, argument, wants, value)
    if value not in known:
        _refuse(WrongValueError, call, argument, wants, value, nearest(value, known))
    return str(value)


def colour(call: str, value: Any) -> str:
    """A colour by name or as #rgb or #rrggbb; in lower case."""
    wants = "the name of a colour or '#rrggbb'"
    if not isinstance(value, str):
        _refuse(WrongTypeError, call, "colour", wants, value)
    word = value.strip().lower()
    digits = word[1:]
    is_hex = word[:1] == "#" and len(digits) in (3, 6) and _HEX_DIGITS.issuperset(digits)
    if not is_hex and word not in COLOURS:
        _refuse(WrongValueError, call, "colour", wants, value, nearest(word, COLOURS))
    return word


def rgb(word: str) -> tuple[int, int, int]:
    """Red, green and blue, 0 to 255, of a colour that `colour` has let through."""
    digits = COLOURS.get(word, word)[1:]
    if len(digits) == 3:
        digits = "".join(digit * 2 for digit in digits)
    return int(digits[:2], 16), int(digits[2:4], 16), int(digits[4:], 16)


def points(call: str, value: Any, layer: str, shape: str) -> tuple[Any, list[str] | None]:
    """The (x, y) points of a layer, and the words of each if it is text."""
    if hasattr(value, "tolist"):  # a NumPy array
        value = value.tolist()
    if isinstance(value, str) or not isinstance(value, Iterable):
        _refuse(WrongTypeError, call, "points", "a list of (x, y) points", value)
    listed = value if isinstance(value, list | tuple) else list(value)
    if shape == "text":
        return _texts(call, listed, layer)
    # A map of 1,600 cells is drawn often: a few passes in C, and a call per point only in doubt.
    if _all_plain(listed):
        return listed, None
    return [_point(call, item, index) for index, item in enumerate(listed)], None


def _all_plain(listed: Sequence[Any]) -> bool:
    """Whether these are pairs of ordinary finite numbers, beyond doubt."""
    try:
        flat = list(chain.from_iterable(listed))
        pairs = set(map(len, listed)) <= {2}
        return pairs and set(map(type, flat)) <= {float, int} and isfinite(sum(flat))
    except (TypeError, OverflowError):  # something without length; an int of hundreds of digits
        return False


def _point(call: str, item: Any, index: int) -> tuple[float, float]:
    if hasattr(item, "tolist"):
        item = item.tolist()
    pair = isinstance(item, list | tuple) and len(item) == 2
    if not pair or any(isinstance(part, bool) or not isinstance(part, _NUMBERS) for part in item):
        raise WrongTypeError(_bad_point(call, item, index))
    try:
        x, y = float(item[0]), float(item[1])
    except (OverflowError, ValueError):
        x = y = inf
    if not (isfinite(x) and isfinite(y)):
        raise WrongValueError(_bad_point(call, item, index))
    return x, y


def _bad_point(call: str, item: Any, index: int) -> str:
    return f"{call} wants two numbers (x, y) in each point; point number {index} is {got(item)}"


def _texts(
    call: str, listed: Sequence[Any], layer: str
) -> tuple[list[tuple[float, float]], list[str]]:
    """Points (x, y, "words"), or (x, y) for the layer's own name."""
    places: list[tuple[float, float]] = []
    words: list[str] = []
    for index, item in enumerate(listed):
        has_words = isinstance(item, list | tuple) and len(item) == 3
        places.append(_point(call, item[:2] if has_words else item, index))
        words.append(storable(str(item[2])) if has_words else layer)
    return places, words


def _refuse(
    kind: type[WrongTypeError] | type[WrongValueError],
    call: str,
    argument: str,
    wants: str,
    value: object,
    meant: str | None = None,
) -> NoReturn:
    # "wait(seconds)" has one argument; where there are several, say which one is meant.
    which = f" for {argument}" if "," in call else ""
    tail = f"; did you mean {meant!r}?" if meant else ""
    raise kind(f"{call} wants {wants}{which}; it got {got(value)}{tail}")
