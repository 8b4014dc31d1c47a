"""Slips in arithmetic: sums without an answer, and questions that an array can't answer.

May import: the standard library, `bugbot.errors`, the rest of `bugbot.run.slips`.

A cause is named where the line leaves no doubt; otherwise only what Python asks for is said.
"""

from __future__ import annotations

import ast
import re
from typing import Any

from bugbot.errors import BugbotError
from bugbot.run.slips.case import Case, Slip

__all__ = ["SLIPS"]

_LONGEST_SHOWN = 40

_WORKS_FOR = {
    **dict.fromkeys(("log", "log2", "log10"), "above 0"),
    "log1p": "above -1",
    "sqrt": "from 0 up",
    **dict.fromkeys(("asin", "acos"), "from -1 to 1"),
    "atanh": "between -1 and 1",
    "acosh": "from 1 up",
}


def _shown(node: ast.expr) -> str | None:
    text = ast.unparse(node)
    return text if len(text) <= _LONGEST_SHOWN else None


def _division(case: Case) -> str | None:
    if not isinstance(case.error, ZeroDivisionError):
        return None
    if "power" in case.message:
        return "0 has no negative power: it would be a division by 0."
    divisors = [
        each.right if isinstance(each, ast.BinOp) else each.value
        for each in case.parts(ast.BinOp, ast.AugAssign)
        if isinstance(each.op, ast.Div | ast.FloorDiv | ast.Mod)
    ]
    if len(divisors) != 1 or not case.raised_on_it:
        return "Something here is divided by 0: ask with if before dividing."
    (divisor,) = divisors
    if isinstance(divisor, ast.Constant):
        return "Nothing can be divided by 0."
    text = _shown(divisor)
    return f"{text or 'What it is divided by'} is 0 here: ask with if before dividing."


def _too_large(case: Case) -> str | None:
    if not isinstance(case.error, OverflowError) or "index-sized" in case.message:
        return None
    hint = "The number gets too large."
    if _called(case, {"exp"}):
        hint += " exp() of more than 709 does: clamp what goes into it."
    return hint


def _no_answer(case: Case) -> str | None:
    """`math.log(p / 1 - p)`, `math.sqrt(-1)`."""
    asked = re.search(
        r"math domain error|expected a (positive|nonnegative) (input|number)|range from",
        case.message,
    )
    if not isinstance(case.error, ValueError) or not asked:
        return None
    calls = _called(case, set(_WORKS_FOR))
    names = {name for name, _ in calls}
    if len(names) != 1 or not case.raised_on_it:
        return "log() wants more than 0, sqrt() 0 or more, asin() and acos() from -1 to 1."
    (name,) = names
    part: Any
    for _, call in calls:
        for part in filter(_lacks_brackets, ast.walk(call)):
            p = ast.unparse(part.right)
            return (
                f"Python divides before it subtracts, so {p} / 1 - {p} is {p} - {p}. Put brackets "
                f"round what you divide by: {p} / (1 - {p})"
            )
    return (
        f"{name}() only works for numbers {_WORKS_FOR[name]}: print what it is given here, and see "
        "where that comes from."
    )


def _lacks_brackets(part: Any) -> bool:
    """Whether this is `p / 1 - p`."""
    return (
        isinstance(part, ast.BinOp)
        and isinstance(part.op, ast.Sub)
        and isinstance(part.left, ast.BinOp)
        and isinstance(part.left.op, ast.Div)
        and isinstance(part.left.right, ast.Constant)
        and part.left.right.value == 1
        and ast.dump(part.left.left) == ast.dump(part.right)
    )


def _called(case: Case, names: set[str]) -> list[tuple[str, ast.Call]]:
    """The calls on the line of functions with one of these names."""
    return [
        (name, call)
        for call in case.parts(ast.Call)
        for name in (getattr(call.func, "attr", None) or getattr(call.func, "id", None),)
        if name in names
    ]


def _not_a_number(case: Case) -> str | None:
    if isinstance(case.error, BugbotError) and re.search(
        r"(it|\d) (got|is) .*\b(nan|inf)\b", case.message
    ):
        return (
            "nan and inf come from sums without an answer, like inf - inf: look where it came in."
        )
    return None


def _array_truth(case: Case) -> str | None:
    if "truth value of an array" not in case.message:
        return None
    asks = ", and then ask the result with .any() or .all()." if _in_if(case) else "."
    for each in case.parts(ast.BoolOp):
        word, sign = ("and", "&") if isinstance(each.op, ast.And) else ("or", "|")
        return (
            f"{word} works with one yes or no, and an array has many. For arrays write {sign}, "
            f"with brackets round each side, like (a > 0) {sign} (b < 9){asks}"
        )
    if any(len(each.ops) > 1 for each in case.parts(ast.Compare)):
        return (
            "a < b < c works with single numbers. For arrays ask twice and join the two with &, "
            f"like (a < b) & (b < c){asks}"
        )
    if any(isinstance(each.op, ast.Not) for each in case.parts(ast.UnaryOp)):
        return (
            "not works with one yes or no, and an array has many. For arrays write ~ in its place."
        )
    for name, _ in _called(case, {"max", "min"}):
        return f"{name}() wants single numbers. Cell by cell it is np.{name}imum(a, b)."
    return "An array has many answers: ask with (…).any() or (…).all()"


def _in_if(case: Case) -> bool:
    return re.match(r"\s*(if|elif|while|assert)\b", case.text) is not None


SLIPS: tuple[Slip, ...] = (_division, _too_large, _no_answer, _not_a_number, _array_truth)
