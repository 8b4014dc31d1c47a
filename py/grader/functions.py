"""Judging what a learner's functions have answered.

May import: the standard library, the rest of `grader`, `performer.limits`, `performer.values`.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Any

from bugbot.errors import listed, times
from bugbot.run.slips.newer import PAGE
from grader.asking import NOT_SAID, Answered, Call, Look, Step
from grader.compare import near
from grader.declare import Function, Mistake
from grader.difference import difference, told_in_words
from grader.failures import ArgumentChanged, CheckFailed, ProgramFailed
from grader.places import cells_in, grid_difference, where_cells
from grader.slips import Wrong, explaining, usual_slip
from grader.text import Source, Text
from performer.limits import CALL_S
from performer.values import MalformedError, decoded, shown

__all__ = ["fault_text", "judge_steps"]

_EXACT_BUT_FOR_SUMS = near(1e-6)

_COPIED = ("list", "set", "dict")
"""Kinds whose name makes a copy when it is called."""

_MOST_CALLS = 3
"""So many different calls are named before a variable; of more, only the last."""


def fault_text(fault: dict[str, Any]) -> str:
    """A fault in one line: NameError on line 4: name 'flor' is not defined."""
    line = fault.get("line")
    where = "" if not isinstance(line, int) else f" on line {line}"
    version = ""
    if fault.get("type") == "SyntaxError" and sys.version_info < PAGE:
        version = f" (Python {sys.version_info[0]}.{sys.version_info[1]} marks this)"
    return f"{fault.get('type')}{where}: {fault.get('message')}"[:600] + version


def judge_steps(
    steps: Sequence[Step],
    answers: Sequence[dict[str, Any]],
    others: Iterable[Answered],
    world: dict[str, Any],
    source: Source,
) -> None:
    """Hold each answer against what is right; CheckFailed for the first that is not.

    others  all the calls of the file that were answered: a slip that explains them all is it
    """
    known = list(others)
    made: list[Call] = []
    for step, answer in zip(steps, answers, strict=False):
        if isinstance(step, Call):
            _judge_call(step, answer, known, world, source)
            made.append(step)
        elif isinstance(step, Look):
            _judge_look(step, answer, made, world, source)


def _judge_call(
    call: Call,
    answer: dict[str, Any],
    known: Sequence[Answered],
    world: dict[str, Any],
    source: Source,
) -> None:
    right = call.expected()
    _refuse_what_is_no_answer(call, answer)
    every = [pair for pair in known if pair[0].function is call.function]
    text = source.of(call.function.name)
    if "fault" in answer:
        mistake = explaining(call.function.mistakes, every, text)
        fault = answer["fault"]
        raise CheckFailed(
            call.should(shown(right)),
            fault_text(fault),
            likely=mistake.text if mistake else fault.get("hint"),
            hint=mistake.hint if mistake else None,
        )
    value = _value(answer)
    if call.function.compare(right, value):
        _must_have_left_its_arguments(call, answer)
        return
    expected, got, cells = _apart(call.function, right, value)
    mistake = explaining(call.function.mistakes, every, text)
    wrong = Wrong(call, answer, right, value, every, text)
    raise CheckFailed(
        call.should(expected, whole=expected.startswith(shown(right))),
        f"{call} returned None" if value is None and call.function.changes is None else got,
        likely=mistake.text if mistake else usual_slip(wrong),
        hint=mistake.hint if mistake else None,
        where=where_cells(call.function.cell_cm or call.function.grid_cm, cells, world),
    )


def _must_have_left_its_arguments(call: Call, answer: dict[str, Any]) -> None:
    """Refuse a right answer that was had by changing what the function was given."""
    for number, encoded in answer.get("altered", []):
        name, before = call.function.parameters[number], call.arguments[number]
        now = _value({"value": encoded})
        kind = type(before).__name__
        copied = f"{kind}({name})" if type(now) is type(before) and kind in _COPIED else "a copy"
        inner = isinstance(before, list) and isinstance(now, list) and _changed_inside(before, now)
        raise ArgumentChanged(
            call.after(f"{name} is as it was: {shown(before)}"),
            shown(now),
            likely=(
                f"{name} has to stay as it was, but what is in it was changed: copy each part first"
                if inner
                else f"{name} has to stay as it was, but your function changes it: "
                f"work on a copy, {copied}"
            ),
        )


def _changed_inside(before: list[Any], now: list[Any]) -> bool:
    """Whether it is the parts of a list that were changed, not the list."""
    return len(before) == len(now) and any(
        isinstance(old, list | set | dict) and new not in before
        for old, new in zip(before, now, strict=True)
    )


def _apart(function: Function, right: Any, value: Any) -> tuple[str, str, list[tuple[int, int]]]:
    """Where an answer parts from what is right: in words, and the cells concerned."""
    if function.grid_cm is not None:
        on_grid = grid_difference(function.compare, function.grid_cm, right, value)
        if on_grid is not None:
            return on_grid
    cells = set() if function.cell_cm is None else cells_in(right) ^ cells_in(value)
    if cells and told_in_words(function.compare, right, value) is not None:
        cells = cells_in(value)  # another answer would do as well: the learner's own is shown
    return *difference(function.compare, right, value), sorted(cells)


def _refuse_what_is_no_answer(call: Call, answer: dict[str, Any]) -> None:
    """The function is not there, can't be called like this, or never came back."""
    signature = call.function.signature
    if "missing" in answer:
        raise ProgramFailed(
            f"a function {signature}",
            f"the program has no {call.function.name}",
            likely=_near_name(answer.get("near")),
        )
    if "no function" in answer:
        raise ProgramFailed(
            f"a function {signature}",
            f"{call.function.name} is {answer['no function']}, not a function",
            likely=f"the name {call.function.name} is used for something else further down",
        )
    if "parameters" in answer:
        own = f"{call.function.name}{answer['parameters']}"
        raise ProgramFailed(
            f"a function {signature} that can be called with {_count(len(call.arguments))}",
            f"yours is {own}, which can't be called like that",
            likely="the function's parameters are not those that the task names",
        )
    if "late" in answer:
        line = answer["late"]
        where = f" on line {line}" if isinstance(line, int) else ""
        raise CheckFailed(
            f"an answer to {call}",
            f"it was still computing{where} when it was stopped, after {CALL_S:g} s of computing",
            likely=(
                "it is very slow, or it has a loop that never ends: does what the loop tests "
                "change inside it?"
            ),
        )


def _count(arguments: int) -> str:
    return f"{arguments} argument{'' if arguments == 1 else 's'}"


def _near_name(near: object) -> str | None:
    if not isinstance(near, str):
        return None
    return f"the program has {near}: perhaps that is the one, under another name"


def _value(answer: dict[str, Any]) -> Any:
    try:
        return decoded(answer["value"])
    except (MalformedError, KeyError):
        raise ProgramFailed(
            "an answer that can be read", "what came back from the program was garbled"
        ) from None


# -- variables -----------------------------------------------------------------


def _judge_look(
    look: Look,
    answer: dict[str, Any],
    made: Sequence[Call],
    world: dict[str, Any],
    source: Source,
) -> None:
    if "missing" in answer:
        raise CheckFailed(
            f"a variable {look.name} in the program",
            "there is none",
            likely=_near_name(answer.get("near")),
        )
    if look.gives is NOT_SAID:
        return
    value = _value(answer)
    if look.compare(look.gives, value):
        return
    cells: list[tuple[int, int]] = []
    on_grid = None
    if look.grid_cm is not None:
        on_grid = grid_difference(look.compare, look.grid_cm, look.gives, value)
    if on_grid is not None:
        expected, got, cells = on_grid
    else:
        expected, got = difference(look.compare, look.gives, value)
    verb = "is" if expected.startswith(shown(look.gives)) else "has"
    text = source.of(made[-1].function.name if made else None)
    mistake = _leaving(look.mistakes, value, text)
    raise CheckFailed(
        f"{_after(made)}{look.name} {verb} {expected}",
        got,
        likely=mistake.text if mistake else None,
        hint=mistake.hint if mistake else None,
        where=where_cells(look.grid_cm, cells, world),
    )


def _leaving(mistakes: Sequence[Mistake], value: Any, text: Text) -> Mistake | None:
    """The mistake that would leave exactly this value in the variable."""
    fitting = (each for each in mistakes if each.can_be(text))
    return next((each for each in fitting if _EXACT_BUT_FOR_SUMS(each.slip(), value)), None)


def _after(made: Sequence[Call]) -> str:
    """The calls that a variable's value comes from, for whoever wants to repeat them."""
    counts = Counter(map(str, made))
    if not counts:
        return ""
    if len(counts) > _MOST_CALLS:
        return f"after {len(made)} calls, the last of them {made[-1]}, "
    told = [f"{call} ({times(count)})" if count > 1 else call for call, count in counts.items()]
    return f"after {listed(told)}, "
