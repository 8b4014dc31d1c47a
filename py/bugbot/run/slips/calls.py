"""Slips with functions: brackets forgotten, names covered up, what they give back.

May import: the standard library, `bugbot.errors`, the rest of `bugbot.run.slips`.
"""

from __future__ import annotations

import re
from inspect import signature

from bugbot.errors import BugbotError, nearest
from bugbot.run.slips.case import CALLS, Case, Slip, bare_calls

__all__ = ["SLIPS"]

_SIDES = "turn(90) is to the right, turn(-90) to the left."

_GIVES = {
    "scan": "8 pairs: for angle, distance_cm in scan():",
    "position": "two numbers: x, y = position()",
    "odometry": "three numbers: x, y, facing = odometry()",
}
"""The calls that give more than one number, and how to take it apart."""


def _brackets_forgotten(case: Case) -> str | None:
    """A function where its result was meant: `for a, d in scan:`, `if distance < 20:`."""
    about_functions = re.search(r"\b(function|builtin_function_or_method|method)\b", case.message)
    if not isinstance(case.error, TypeError) or not about_functions:
        return None
    if re.search(r"\(\) (missing|takes|got)", case.message):
        return None
    named = re.search(r"the function (\w+)", case.message)
    if named and named[1] in ("left", "right") and case.message.startswith("turn("):
        return _SIDES
    names = [named[1]] if named else bare_calls(case)
    if not names:
        return None
    name = names[0]
    return f"{name} is a function: to use what it gives, call it with brackets: {name}()"


def _covered_up(case: Case) -> str | None:
    """`distance = distance()` works once; then the name is a number."""
    found = re.match(r"'(?:numpy\.)?(\w+)' object is not callable", case.message)
    if not found:
        return None
    kind = found[1]
    for name in re.findall(r"\b([A-Za-z_]\w*)\s*\(", case.code):
        value = case.scope.get(name)
        if callable(value) or name not in case.scope:
            continue
        covered = _defined_and_set(case, name)
        if covered is not None:
            return (
                f"Line {covered} sets {name} to a value of type {kind}, so the function of that "
                "name is gone: choose another name for one of the two."
            )
        if name in CALLS:
            return (
                f"A line above makes {name} a value of type {kind}, so the robot's call {name}() "
                f"is covered up: choose another name there, like my_{name}."
            )
        if kind in ("list", "tuple", "dict", "ndarray"):
            what = "an array" if kind == "ndarray" else f"a {kind}"
            return f"{name} is {what}: to take something out of it use square brackets: {name}[…]"
        missing = f" To multiply write *: {name} * (…)" if kind in ("int", "float") else ""
        return f"{name} is a value of type {kind}, and that can't be called.{missing}"
    if kind in ("int", "float"):
        after = re.search(r"(\d|[)\]])\s*\(", case.code)
        if after is None:
            return None
        what = "a number" if after[1].isdigit() else "another bracket"
        return f"A bracket right after {what} makes a call of it. To multiply write *: 2 * (x + 1)"
    if kind in ("tuple", "list", "str"):
        return "Is there a comma missing between two things in a list?"
    return None


def _defined_and_set(case: Case, name: str) -> int | None:
    """The line that gives a value to the name of a function of the program's own."""
    if not any(re.match(rf"\s*def\s+{name}\s*\(", text) for text in case.lines):
        return None
    sets = re.compile(rf"\s*(?:for\s+)?(?:[\w*]+\s*,\s*)*{name}\s*(?:,[^=()]*)?(?:=(?!=)|\bin\b)")
    return next((at for at, text in enumerate(case.lines, 1) if sets.match(text)), None)


def _unpacked_wrongly(case: Case) -> str | None:
    """`a, d = scan()`, `x, y, h = position()`, `for d in scan()` and then `a, d = d[0]`."""
    if not re.search(r"to unpack|cannot unpack", case.message):
        return None
    table = re.match(r"\s*for\s+.+\s+in\s+(\w+)\s*:", case.code)
    if table and isinstance(case.scope.get(table[1]), dict):
        return f"A dictionary gives its keys; for both: for key, value in {table[1]}.items():"
    for name, gives in _GIVES.items():
        if re.search(rf"\b{name}\s*\(", case.code):
            return f"{name}() gives {gives}"
    found = re.search(r"expected (at least )?(\d+)(?:, got (\d+))?", case.message)
    if found:
        if found[1]:
            least = f"{found[2]} value{'' if found[2] == '1' else 's'}"
            return f"The names on the left want at least {least} and get {found[3]}."
        names = f"{found[2]} name{'' if found[2] == '1' else 's'}"
        if not found[3]:  # before Python 3.14 it does not count them
            return f"There are more values than the {names} on the left."
        return f"The {names} on the left get {found[3]} value{'' if found[3] == '1' else 's'}."
    return "Only a list, a tuple or the like can be taken apart into several names."


def _sequence_as_number(case: Case) -> str | None:
    """`if scan() < 20`, `position() + 1`, `for d in distance()`."""
    if not isinstance(case.error, TypeError) or isinstance(case.error, BugbotError):
        return None
    if not re.search(
        r"'(list|tuple)' and|and '(list|tuple)'|not '?(list|tuple)'?$|to (list|tuple)$",
        case.message,
    ):
        return None
    for name, gives in _GIVES.items():
        if re.search(rf"\b{name}\s*\(", case.code):
            return f"{name}() gives {gives}"
    return None


def _none(case: Case) -> str | None:
    """A value that is None because a function returned nothing."""
    is_none = re.search(r"NoneType|it got None$", case.message)
    if not is_none or not isinstance(case.error, TypeError):
        return None
    return (
        "Something here is None. A function without a return gives None, and so do calls like "
        "draw(), print(), append() and sort()."
    )


def _method_without_self(case: Case) -> str | None:
    found = re.match(r"(\w+)\.(\w+)\(\) takes (\d+) positional arguments? but (\d+)", case.message)
    if not found or int(found[4]) != int(found[3]) + 1:
        return None
    return f"The method {found[2]} needs self as its first argument: def {found[2]}(self, …):"


def _own_function(case: Case) -> str | None:
    """A function of the learner's, called with too many or too few arguments."""
    found = re.match(r"(?:\w+\.)*(\w+)\(\) (missing|takes|got)", case.message)
    if not isinstance(case.error, TypeError) or not found:
        return None
    for number, text in enumerate(case.lines, 1):
        if re.match(rf"\s*def\s+{found[1]}\s*\(", text):
            return f"{found[1]} is defined on line {number}: {text.strip()}"
    return None


def _keyword(case: Case) -> str | None:
    found = re.search(r"(\w+)\(\) got an unexpected keyword argument '(\w+)'", case.message)
    if not found:
        return None
    if found[2] == "color":
        return "It is spelt colour here."
    if found[2] in ("time", "seconds", "duration", "t") and found[1] in CALLS:
        return f"To go on for a time: {found[1]}(50) and then wait(3)."
    function = case.scope.get(found[1])
    if found[1] in CALLS and callable(function):
        near = nearest(found[2], list(signature(function).parameters))
        return f"Did you mean {near}?" if near else None
    return None


def _side(case: Case) -> str | None:
    """`turn("left")`, `turn(90, speed=-30)`."""
    if not isinstance(case.error, BugbotError) or not case.message.startswith("turn("):
        return None
    word = re.search(r"it got '(left|right)'$", case.message, re.IGNORECASE)
    negative = re.search(r"for speed; it got -[\d.]+$", case.message)
    return _SIDES if word or negative else None


def _number_in_quotes(case: Case) -> str | None:
    if isinstance(case.error, BugbotError) and re.search(r"it got '-?[\d.]+'$", case.message):
        return "A number is written without quotes; int() or float() makes one of a text."
    return None


def _endless_calls(case: Case) -> str | None:
    if isinstance(case.error, RecursionError):
        return (
            "A function that calls itself needs an if that ends it, and must come nearer to that."
        )
    return None


def _thread(case: Case) -> str | None:
    if "can't start new thread" in case.message:
        return "The robot's programs do one thing after another: there are no threads here."
    return None


SLIPS: tuple[Slip, ...] = (
    _brackets_forgotten,
    _covered_up,
    _unpacked_wrongly,
    _sequence_as_number,
    _keyword,
    _side,
    _number_in_quotes,
    _none,
    _method_without_self,
    _own_function,
    _endless_calls,
    _thread,
)
