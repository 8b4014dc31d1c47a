"""Judging the calls of a learner's functions, and naming the slip behind wrong answers.

May import: the standard library, `bugbot.errors`, the rest of `grader`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from copy import deepcopy
from dataclasses import dataclass
from typing import Any

from grader.compare import Compare, difference, exactly, near
from grader.declare import Function, Mistake
from grader.failures import AuthorError, CheckFailed, ProgramFailed
from grader.places import cells_in, grid_difference, where_cells
from grader.values import MalformedError, Other, decoded, encoded, shown

__all__ = ["NOT_SAID", "Answered", "Call", "Look", "Set", "Step", "fault_text", "judge_steps"]

NOT_SAID: Any = object()
"""Stands for an expectation that is left to the reference."""


@dataclass(frozen=True, slots=True)
class Call:
    """One call of the learner's function, and what it should answer."""

    function: Function
    arguments: tuple[Any, ...]
    gives: Any = NOT_SAID

    def request(self) -> dict[str, Any]:
        """As the performer is asked for it."""
        function = self.function
        request: dict[str, Any] = {
            "function": function.name,
            "arguments": [encoded(each) for each in self.arguments],
        }
        if function.changes is not None:
            request["changes"] = function.parameters.index(function.changes)
        return request

    def __str__(self) -> str:
        return f"{self.function.name}({', '.join(map(shown, self.arguments))})"

    @property
    def verb(self) -> str:
        """How its expectation is put into words."""
        changed = self.function.changes
        return "gives" if changed is None else f"leaves in {changed}"

    def answer_of(self, work: Any) -> Any:
        """What another function, the reference or a slip, answers to the same call."""
        arguments = deepcopy(self.arguments)
        returned = work(*arguments)
        changes = self.function.changes
        changed = (
            returned if changes is None else arguments[self.function.parameters.index(changes)]
        )
        # As a learner's answer would arrive: NumPy's numbers and arrays become plain.
        return decoded(encoded(changed))

    def expected(self) -> Any:
        """What is right; AuthorError if reference and check.py don't agree on it."""
        try:
            right = self.answer_of(self.function.reference)
        except Exception as error:
            raise AuthorError(
                f"the reference for {self} raised {type(error).__name__}: {error}"
            ) from error
        if self.gives is not NOT_SAID and not self.function.compare(self.gives, right):
            said = f"{self} is said to give {shown(self.gives)}"
            raise AuthorError(f"{said}, but the reference gives {shown(right)}")
        return right


@dataclass(frozen=True, slots=True)
class Set:
    """A variable of the learner's program, set for the calls after it."""

    name: str
    value: Any

    def request(self) -> dict[str, Any]:
        """As the performer is asked for it."""
        return {"set": self.name, "value": encoded(self.value)}


@dataclass(frozen=True, slots=True)
class Look:
    """A look at a variable of the learner's program."""

    name: str
    gives: Any
    compare: Compare

    def request(self) -> dict[str, Any]:
        """As the performer is asked for it."""
        return {"variable": self.name}


Step = Call | Set | Look
Answered = tuple[Call, dict[str, Any]]
"""A call with the performer's answer to it."""


def fault_text(fault: dict[str, Any]) -> str:
    """A fault in one line: NameError on line 4: name 'flor' is not defined."""
    line = fault.get("line")
    where = "" if not isinstance(line, int) else f" on line {line}"
    return f"{fault.get('type')}{where}: {fault.get('message')}"[:600]


def judge_steps(
    steps: Sequence[Step],
    answers: Sequence[dict[str, Any]],
    others: Iterable[Answered],
    world: dict[str, Any],
) -> None:
    """Hold each answer against what is right; CheckFailed for the first that is not.

    others  all the calls of the file that were answered: a slip that explains them all is it
    """
    known = list(others)
    for step, answer in zip(steps, answers, strict=False):
        if isinstance(step, Call):
            own = [
                (each, reply)
                for each, reply in zip(steps, answers, strict=False)
                if isinstance(each, Call) and each.function is step.function
            ]
            _judge_call(step, answer, own, known, world)
        elif isinstance(step, Look):
            _judge_look(step, answer)


def _judge_call(
    call: Call,
    answer: dict[str, Any],
    own: Sequence[Answered],
    known: Sequence[Answered],
    world: dict[str, Any],
) -> None:
    right = call.expected()
    _refuse_what_is_no_answer(call, answer)
    every = [pair for pair in known if pair[0].function is call.function]
    if "fault" in answer:
        mistake = _explaining(call.function.mistakes, every, own)
        fault = answer["fault"]
        raise CheckFailed(
            f"{call} {call.verb} {shown(right)}",
            fault_text(fault),
            likely=mistake.text if mistake else fault.get("hint"),
            hint=mistake.hint if mistake else None,
        )
    value = _value(answer)
    if call.function.compare(right, value):
        return
    expected, got, cells = _apart(call.function, right, value)
    mistake = _explaining(call.function.mistakes, every, own)
    raise CheckFailed(
        f"{call} {call.verb} {expected}",
        got,
        likely=mistake.text if mistake else _usual_slip(call, right, value, answer, every),
        hint=mistake.hint if mistake else None,
        where=where_cells(call.function, cells, world),
    )


def _apart(function: Function, right: Any, value: Any) -> tuple[str, str, list[tuple[int, int]]]:
    """Where an answer parts from what is right: in words, and the cells concerned."""
    if function.grid_cm is not None:
        on_grid = grid_difference(function, right, value)
        if on_grid is not None:
            return on_grid
    cells = cells_in(right) ^ cells_in(value) if function.cell_cm is not None else set()
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
            f"yours is {own}, which can't",
            likely="the function's parameters are not those that the task names",
        )
    if "late" in answer:
        line = answer["late"]
        where = f", on line {line}" if isinstance(line, int) else ""
        raise CheckFailed(
            f"an answer to {call}",
            f"it went on computing{where}, and was ended",
            likely="there is a loop that never ends: does what it tests change inside it?",
        )


def _count(arguments: int) -> str:
    return f"{arguments} argument{'' if arguments == 1 else 's'}"


def _near_name(near: object) -> str | None:
    if not isinstance(near, str):
        return None
    return f"the program has {near}: is that the one, under another name?"


def _value(answer: dict[str, Any]) -> Any:
    try:
        return decoded(answer["value"])
    except (MalformedError, KeyError):
        raise ProgramFailed(
            "an answer that can be read", "what came back from the program was garbled"
        ) from None


# -- which slip ----------------------------------------------------------------


def _explaining(
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


def _usual_slip(
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


# -- variables -----------------------------------------------------------------


def _judge_look(look: Look, answer: dict[str, Any]) -> None:
    if "missing" in answer:
        raise CheckFailed(
            f"a variable {look.name} in the program",
            "there is none",
            likely=_near_name(answer.get("near")),
        )
    if look.gives is NOT_SAID:
        return
    value = _value(answer)
    if not look.compare(look.gives, value):
        expected, got = difference(look.compare, look.gives, value)
        raise CheckFailed(f"{look.name} is {expected}", got)
