"""What a check asks of the learner's functions, step by step.

May import: the standard library, `grader.compare`, `grader.declare`, `grader.failures`,
`performer.values`.
"""

from __future__ import annotations

from copy import deepcopy
from dataclasses import dataclass
from typing import Any

from grader.compare import Compare
from grader.declare import Function, Mistake
from grader.failures import AuthorError
from performer.values import decoded, encoded, shown

__all__ = ["NOT_SAID", "Answered", "Call", "Look", "Step"]

NOT_SAID: Any = object()
"""Stands for an expectation that is left to the reference."""


@dataclass(frozen=True, slots=True)
class Call:
    """One call of the learner's function, and what it should answer."""

    function: Function
    arguments: tuple[Any, ...]
    gives: Any = NOT_SAID
    constants: tuple[tuple[str, Any], ...] = ()
    """What the check has changed in the program before it ran."""

    def request(self) -> dict[str, Any]:
        """As the performer is asked for it."""
        function = self.function
        request: dict[str, Any] = {
            "function": function.name,
            "arguments": [encoded(each) for each in self.arguments],
        }
        if function.changes is not None:
            request["changes"] = function.parameters.index(function.changes)
        if function.leaves:
            request["leaves"] = True
        return request

    def __str__(self) -> str:
        return f"{self._conditions}{self._call}"

    @property
    def _call(self) -> str:
        return f"{self.function.name}({', '.join(map(shown, self.arguments))})"

    @property
    def _conditions(self) -> str:
        changed = ", ".join(f"{name} = {shown(value)}" for name, value in self.constants)
        return f"with {changed}, " if changed else ""

    def should(self, expected: str, *, whole: bool = True) -> str:
        """Its expectation in words.

        whole  `expected` is the entire value; else it names a part of it, such as "3 as item 2"
        """
        changed = self.function.changes
        if changed is None:
            return f"{self} gives {expected}"
        verb = "is" if whole else "has"
        return self.after(f"{changed} {verb} {expected}")

    def after(self, holds: str) -> str:
        """What holds after the call, in words."""
        return f"{self._conditions}after {self._call}, {holds}"

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
class Look:
    """A look at a variable of the learner's program."""

    name: str
    gives: Any
    compare: Compare
    mistakes: tuple[Mistake, ...] = ()
    """Their slips take nothing and give the value that the variable would have."""
    grid_cm: float | None = None

    def request(self) -> dict[str, Any]:
        """As the performer is asked for it."""
        return {"variable": self.name}


Step = Call | Look
Answered = tuple[Call, dict[str, Any]]
"""A call with the performer's answer to it."""
