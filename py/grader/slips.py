"""Which mistake explains a learner's wrong answers.

May import: the standard library, the rest of `grader`.

Each likely mistake of a check.py is a function that answers as the mistake would. It is named only
if it gives all the answers that the learner's function has given in the whole file, and if nothing
in the program's text speaks against it. A few mistakes are the same in every task: those are
known here.
"""

from __future__ import annotations

import ast
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from bugbot.run.faults import fault_of
from grader.asking import Answered, Call
from grader.compare import exactly, near
from grader.declare import Mistake
from grader.kinds import other_kind
from grader.returns import why_none
from grader.text import Text
from performer.values import DecimalFloat, MalformedError, Other, decoded

__all__ = ["Wrong", "explaining", "usual_slip"]


@dataclass(frozen=True, slots=True)
class Wrong:
    """A wrong answer, and what may explain it."""

    call: Call
    answer: dict[str, Any]
    right: Any
    value: Any
    every: Sequence[Answered]
    """All calls of the function in the file, with their answers."""
    text: Text
    """The function as it is written."""


def explaining(
    mistakes: Sequence[Mistake], every: Sequence[Answered], text: Text
) -> Mistake | None:
    """The mistake whose answers are those given to all calls of the file."""
    for mistake in mistakes:
        if every and mistake.can_be(text) and all(_explains(mistake, *pair) for pair in every):
            return mistake
    return None


def _explains(mistake: Mistake, call: Call, answer: dict[str, Any]) -> bool:
    try:
        slipped = call.answer_of(mistake.slip)
    except Exception as error:
        fault = answer.get("fault")
        return isinstance(fault, dict) and _same_error(fault, error)
    if "value" not in answer:
        return False
    compare = call.function.compare
    try:
        value = decoded(answer["value"])
    except MalformedError:
        return False
    if not compare(slipped, value):
        return False
    right = call.expected()
    return compare(right, value) or not compare(right, slipped)


def _same_error(fault: dict[str, Any], error: Exception) -> bool:
    """Whether the learner's error is the mistake's: of its kind, and in the same words."""
    likewise = fault_of(error, "", "the mistake")
    return (fault.get("type"), fault.get("message")) == (likewise.type, likewise.message)


def usual_slip(wrong: Wrong) -> str | None:
    """What the grader itself can tell from a wrong answer; None where it is not certain."""
    if wrong.text.is_untouched:
        return None  # nobody has made a mistake yet
    if wrong.call.function.changes is not None:
        return _not_changed(wrong) or _other_kind(wrong, [])
    if wrong.value is None:
        return _nothing_returned(wrong)
    return (
        _no_answer_yet(wrong)
        or _other_kind(wrong, [each.expected() for each, _ in wrong.every])
        or _floats(wrong)
        or _always_the_same(wrong)
    )


def _nothing_returned(wrong: Wrong) -> str | None:
    printed = bool(wrong.answer.get("printed"))
    may_be_none = any(each.expected() is None for each, _ in wrong.every)
    left_on = None if may_be_none else wrong.answer.get("left on")
    why = why_none(wrong.text, left_on, printed=printed)
    if why is None and isinstance(wrong.right, list | tuple | set | dict) and not wrong.right:
        return f"an empty {type(wrong.right).__name__} is asked for, not None: return that"
    return why


def _no_answer_yet(wrong: Wrong) -> str | None:
    """An async function, or one with a yield."""
    value, name = wrong.value, wrong.call.function.name
    if not isinstance(value, Other):
        return None
    if value.what == "a coroutine" or isinstance(wrong.text.function, ast.AsyncFunctionDef):
        return f"{name} is an async function, so calling it gives no answer yet: leave out async"
    if value.what == "a generator" and any(
        isinstance(each, ast.Yield | ast.YieldFrom) for each in wrong.text.own_nodes()
    ):
        return f"{name} has a yield, so calling it gives a generator: gather a list and return it"
    if value.what in _FUNCTIONS:
        return "it returns a function itself: to use what that gives, call it with brackets"
    return None


def _other_kind(wrong: Wrong, rights: Sequence[Any]) -> str | None:
    """In what kind the answer differs, unless the task takes that kind as well."""
    right, value = wrong.right, wrong.value
    if isinstance(right, list | tuple) and isinstance(value, set | frozenset):
        try:
            if wrong.call.function.compare(right, set(right)):
                return None
        except TypeError:
            pass  # what is right has parts that no set can hold
    return other_kind(right, value, rights)


_FUNCTIONS = ("a function", "a builtin_function_or_method", "a method")


def _floats(wrong: Wrong) -> str | None:
    if wrong.call.function.compare is exactly and near(1e-9)(wrong.right, wrong.value):
        if _has_decimals(wrong.value):
            return "the numbers are right, but they are Decimals: int() makes whole numbers of them"
        return (
            "the numbers are right, but they are floats where whole numbers are wanted: "
            "math.floor() and int() make whole numbers, .astype(int) those of an array"
        )
    return None


def _has_decimals(value: Any) -> bool:
    parts = value if isinstance(value, list | tuple) else [value]
    return any(isinstance(each, DecimalFloat) for each in parts)


def _not_changed(wrong: Wrong) -> str | None:
    name = wrong.call.function.changes
    if "returned" not in wrong.answer:
        return None
    try:
        returned = decoded(wrong.answer["returned"])
    except MalformedError:
        return None
    if not wrong.call.function.compare(wrong.right, returned):
        return None
    return f"it returns a new value and leaves {name} as it was: change {name} itself"


def _always_the_same(wrong: Wrong) -> str | None:
    answers = [reply.get("value", reply) for _, reply in wrong.every]
    rights = [each.expected() for each, _ in wrong.every]
    always_the_same = len(answers) > 2 and all(each == answers[0] for each in answers)
    if always_the_same and not all(exactly(rights[0], each) for each in rights):
        return "it gives the same answer whatever it is asked"
    return None
