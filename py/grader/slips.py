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
from grader.compare import exactly, in_any_order, near
from grader.declare import Mistake
from grader.text import Text
from performer.values import MalformedError, Other, decoded, shown

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


_LAZY = (
    "a generator",
    "a map",
    "a filter",
    "a zip",
    "a dict_keys",
    "a dict_values",
    "a dict_items",
)


def usual_slip(wrong: Wrong) -> str | None:
    """What the grader itself can tell from a wrong answer; None where it is not certain."""
    if wrong.value is None:
        return _nothing_returned(wrong)
    return _other_kind(wrong) or _not_changed(wrong) or _always_the_same(wrong)


def _nothing_returned(wrong: Wrong) -> str | None:
    if isinstance(wrong.right, list | tuple | set | dict) and not wrong.right:
        return f"it gives None where an empty {type(wrong.right).__name__} is asked: return that"
    if wrong.text.returns_a_value:
        return None  # None may be what was chosen
    if wrong.answer.get("printed"):
        return (
            "it prints its answer instead of returning it: print() only shows a value, "
            "return hands it to the caller"
        )
    return (
        "it returns None: a function hands back its answer with return, and this one has no return"
    )


def _other_kind(wrong: Wrong) -> str | None:
    right, value, call = wrong.right, wrong.value, wrong.call
    if isinstance(value, Other):
        if value.what == "a coroutine" or isinstance(wrong.text.function, ast.AsyncFunctionDef):
            name = call.function.name
            return (
                f"{name} is an async function, so calling it gives no answer yet: leave out async"
            )
        if value.what in _LAZY:
            return f"it gives {value.what[2:]}, which is not a list yet: put list() round it"
        return f"it is {value.what}; the task asks for {_kind(right)}"
    if isinstance(value, str) and not isinstance(right, str):
        return "it gives a text, not a value: leave out the quotes, str() and f-strings"
    if isinstance(right, set) and isinstance(value, list | tuple) and in_any_order(right, value):
        return f"it is {_kind(value)}; the task asks for a set: set(…)"
    if isinstance(right, list | tuple) and isinstance(value, set | frozenset):
        return f"it is a set, which has no order; the task asks for {_kind(right)}"
    if call.function.compare is exactly and near(1e-9)(right, value):
        return (
            "the numbers are right, but they are floats where whole numbers are wanted: "
            "math.floor() and int() make whole numbers, .astype(int) those of an array"
        )
    return None


def _kind(value: Any) -> str:
    if isinstance(value, tuple) and 0 < len(value) <= 4:
        return f"a tuple of {len(value)}, such as {shown(value)}"
    names: dict[type, str] = {
        list: "a list",
        tuple: "a tuple",
        set: "a set",
        dict: "a dict",
        str: "a text",
    }
    if isinstance(value, bool):
        return "True or False"
    if isinstance(value, int):
        return "a whole number"
    return "a number" if isinstance(value, float) else names.get(type(value), shown(value))


def _not_changed(wrong: Wrong) -> str | None:
    name = wrong.call.function.changes
    if name is None or "returned" not in wrong.answer:
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
