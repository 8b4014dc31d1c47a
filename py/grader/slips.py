"""Which slip explains a learner's wrong answers.

May import: the standard library, the rest of `grader`.

Each likely slip of a check.py is a function that answers as the slip would. The one whose answers
are the learner's is named. A few slips are the same in every task: those are known here.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from grader.calls import Answered, Call
from grader.compare import exactly, near
from grader.declare import Mistake
from grader.values import MalformedError, Other, decoded

__all__ = ["explaining", "usual_slip"]


def explaining(
    mistakes: Sequence[Mistake], every: Sequence[Answered], own: Sequence[Answered]
) -> Mistake | None:
    """The slip whose answers are those given in the whole file; else in this check."""
    for answered in (every, own):
        for mistake in mistakes:
            if answered and all(_explains(mistake, *pair) for pair in answered):
                return mistake
    return None


def _explains(mistake: Mistake, call: Call, answer: dict[str, Any]) -> bool:
    try:
        slipped = call.answer_of(mistake.slip)
    except Exception as error:
        fault = answer.get("fault")
        return isinstance(fault, dict) and fault.get("type") == type(error).__name__
    if "value" not in answer:
        return False
    try:
        return call.function.compare(slipped, decoded(answer["value"]))
    except MalformedError:
        return False


_LAZY = ("a generator", "a map", "a filter", "a zip", "a range", "a dict_keys", "a dict_values")


def usual_slip(
    call: Call, right: Any, value: Any, answer: dict[str, Any], every: Sequence[Answered]
) -> str | None:
    """What the grader itself can tell from a wrong answer."""
    if value is None:
        if answer.get("printed"):
            return (
                "it prints its answer instead of returning it: print() only shows a value, "
                "return hands it to the caller"
            )
        return "it returns None: a function that should answer needs a return on every way through"
    if isinstance(value, Other) and value.what in _LAZY:
        return f"it gives {value.what[2:]}, which is not a list yet: put list() round it"
    if call.function.compare is exactly and near(1e-9)(right, value):
        return (
            "the numbers are right, but of the wrong kind: where a whole number is wanted, "
            "2.0 will not do for 2 (// with whole numbers and math.floor() give whole numbers)"
        )
    if isinstance(value, str) and not isinstance(right, str):
        return "it gives a text, not a value: leave out the quotes, str() and f-strings"
    answers = [reply.get("value", reply) for _, reply in every]
    rights = [each.expected() for each, _ in every]
    always_the_same = len(answers) > 2 and all(each == answers[0] for each in answers)
    if always_the_same and not all(exactly(rights[0], each) for each in rights):
        return "it gives the same answer whatever it is asked"
    return None
