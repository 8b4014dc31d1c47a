"""Calls the functions of a learner's program, inside its run.

May import: the standard library, `bugbot.errors`, `bugbot.run`, `bugbot.trace`, `performer.limits`,
`performer.patience`, `performer.values`.

An answer is one of

    {"value": …}           what it returned, or what it left in the argument it changes
    {"fault": {…}}         type, message, line and hint of the error it raised
    {"late": line}         it was still computing after `CALL_S` seconds of the processor
    {"missing", "near"}    there is no such name; the nearest there is
    {"no function": …}     the name stands for something else
    {"parameters": "(x)"}  it can't be called with so many arguments
    {"skipped": true}      an earlier call never came back

A value comes with "printed": true if the call has printed something, None with "left on", the line
on which the function was left, and what a function leaves in the argument that it was to change
with "returned" if it has returned something as well. Where a call has to leave its arguments as
they were, "altered" has those that it did not leave: [[number, what it is now], …].
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from types import ModuleType
from typing import Any

from bugbot.errors import got, nearest
from bugbot.run.faults import fault_of
from bugbot.run.limits import LimitReached
from bugbot.trace import Trace
from performer.limits import CALL_S
from performer.patience import Patience
from performer.values import decoded, encoded

__all__ = ["Caller"]


class Caller:
    """Makes the calls of one group, whatever ended the program, and keeps the answers."""

    def __init__(
        self,
        calls: list[dict[str, Any]],
        program: str,
        filename: str,
        patience: Patience,
        names: dict[str, Any] | None = None,
    ) -> None:
        self.answers: list[dict[str, Any]] = []
        self.late = False
        self._calls = calls
        self._names = names or {}
        """What the program's variables are set to before the first call."""
        self._program = program
        self._filename = filename
        self._patience = patience
        self.stopped_on: int | None = None
        """The line on which the program was ended because it had computed for too long."""
        self._trace: Trace | None = None

    def follow(self, trace: Trace) -> None:
        """Take note of the trace of the run that begins."""
        self._trace = trace

    def make_calls(self, module: ModuleType) -> None:
        """Make all calls; for `run_program`, once the program has come to its end."""
        self._patience.end()
        self.stopped_on, self._patience.late_on = self._patience.late_on, None
        vars(module).update(self._names)
        for call in self._calls:
            if self.late:
                self.answers.append({"skipped": True})
                continue
            self.answers.append(self._answer(call, module))

    # -- one call ------------------------------------------------------------

    def _answer(self, call: dict[str, Any], module: ModuleType) -> dict[str, Any]:
        names = vars(module)
        if "variable" in call:
            name = call["variable"]
            if name not in names:
                known = [each for each in names if not each.startswith("_")]
                return {"missing": name, "near": nearest(name, known)}
            return {"value": encoded(names[name])}
        name = call["function"]
        function = names.get(name)
        if name not in names:
            return {"missing": name, "near": nearest(name, self._functions(names))}
        if not callable(function):
            return {"no function": got(function)}
        arguments = [decoded(each) for each in call["arguments"]]
        refused = _refused_parameters(function, arguments)
        if refused is not None:
            return {"parameters": refused}
        answer = self._called(function, arguments, call.get("changes"))
        if call.get("leaves") and "value" in answer:
            now = [encoded(each) for each in arguments]
            altered = [[n, each] for n, each in enumerate(now) if not _same(each, call, n)]
            return {**answer, "altered": altered} if altered else answer
        return answer

    def _functions(self, names: dict[str, Any]) -> list[str]:
        return [
            name
            for name, each in names.items()
            if inspect.isfunction(each) and each.__code__.co_filename == self._filename
        ]

    def _called(
        self, function: Callable[..., Any], arguments: list[Any], changes: int | None
    ) -> dict[str, Any]:
        before = self._printed()
        try:
            # The values are taken apart in time as well: their classes may be the program's own.
            answer: dict[str, Any] = self._patience.have(
                lambda: _answer_of(function(*arguments), arguments, changes), CALL_S
            )
        except (LimitReached, KeyboardInterrupt):
            raise
        except BaseException as error:
            if self._patience.late_on is not None:
                return self._ended()
            fault = fault_of(error, self._program, self._filename)
            return {
                "fault": {
                    "type": fault.type,
                    "message": fault.message,
                    "line": fault.line,
                    "hint": fault.hint,
                }
            }
        if self._patience.late_on is not None:  # it has caught what ended it
            return self._ended()
        if self._printed() != before:
            answer["printed"] = True
        left_on = self._patience.left_on()
        if answer["value"] is None and left_on is not None:
            answer["left on"] = left_on
        return answer

    def _ended(self) -> dict[str, Any]:
        self.late = True
        return {"late": self._patience.late_on}

    def _printed(self) -> tuple[int, int]:
        events = self._trace.events if self._trace is not None else []
        prints = [event for event in events[-1:] if event[0] == "print"]
        return len(events), len(prints[0][3]) if prints else 0


def _answer_of(returned: Any, arguments: list[Any], changes: int | None) -> dict[str, Any]:
    if changes is None:
        return {"value": encoded(returned)}
    answer = {"value": encoded(arguments[changes])}
    return answer if returned is None else {**answer, "returned": encoded(returned)}


def _same(now: Any, call: dict[str, Any], number: int) -> bool:
    """Whether an argument is as it was; the order in which a set gives its parts is nothing."""
    return bool(decoded(now) == decoded(call["arguments"][number]))


def _refused_parameters(function: Callable[..., Any], arguments: list[Any]) -> str | None:
    """The parameters of a function that can't be called with these arguments, else None."""
    try:
        signature = inspect.signature(function)
    except (TypeError, ValueError):
        return None
    try:
        signature.bind(*arguments)
    except TypeError:
        return f"({', '.join(signature.parameters)})"[:100]
    return None
