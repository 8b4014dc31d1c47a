"""What a check.py says at its top level: its checks and the functions it judges.

May import: the standard library, `grader.compare`, `grader.conditions`, `grader.failures`,
`grader.text`.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from grader.compare import Compare, exactly
from grader.conditions import Condition, calls
from grader.failures import AuthorError
from grader.text import Text

__all__ = [
    "Check",
    "Function",
    "Mistake",
    "Scoring",
    "check",
    "checks_of",
    "function",
    "mistake",
    "mistakes_of",
    "noting_mistakes",
    "scoring",
]


@dataclass(frozen=True, slots=True)
class Mistake:
    """A likely mistake: what the learner is told, what shows it, the hint that helps."""

    text: str
    slip: Callable[..., Any]
    hint: int | None = None
    where: tuple[Condition, ...] = ()
    broken_off: bool = False

    def can_be(self, text: Text) -> bool:
        """Whether the program, as it is written, allows this cause."""
        if not text.is_begun:
            return False  # nobody has made a mistake yet
        named = _NAMED_CALL.match(self.text)
        stated = (calls(named[1]),) if named and not self.where else self.where
        return all(condition(text) for condition in stated)


_NAMED_CALL = re.compile(r"(\w+)\(\) ")
"""A cause that begins with "int() cuts …" says that the program calls int()."""


def mistake(
    text: str,
    slip: Callable[..., Any],
    hint: int | None = None,
    *,
    where: Condition | Sequence[Condition] = (),
    broken_off: bool = False,
) -> Mistake:
    """Declare a likely mistake.

    text   what the learner is told
    slip   a function that answers as the mistake would; of runs: run -> whether it looks like it
    hint   number of the task's hint that helps (0 is the first)
    where  what must stand in the learner's function, and in what it calls, for the cause to be
           told, one or several of `grader.conditions`: calls("int"), operator("<"), reads("CELL")
    broken_off  of runs: it explains only those that ended with an error; others never do
    """
    conditions = (where,) if callable(where) else tuple(where)
    return Mistake(text, slip, hint, conditions, broken_off)


@dataclass(frozen=True, slots=True)
class Check:
    """One named check of a check.py."""

    title: str
    hint: int | None
    work: Callable[[Any], object]


@dataclass(frozen=True, slots=True)
class Function:
    """A function that the learner writes; `function` has the words."""

    name: str
    parameters: tuple[str, ...]
    reference: Callable[..., Any]
    compare: Compare
    mistakes: tuple[Mistake, ...]
    changes: str | None
    cell_cm: float | None
    grid_cm: float | None
    leaves: bool

    @property
    def signature(self) -> str:
        """As the learner must define it, without its parameters' defaults."""
        return f"{self.name}({', '.join(self.parameters)})"


@dataclass(frozen=True, slots=True)
class Scoring:
    """How the runs of a file are scored; `scoring` has the words."""

    how: str
    points: Callable[..., float]
    of: float


@dataclass(slots=True)
class _File:
    """The checks of the file that is being read."""

    checks: list[Check] = field(default_factory=list)


_reading: list[_File] = []
_noted: list[list[Mistake]] = []


@contextmanager
def noting_mistakes() -> Iterator[list[Mistake]]:
    """Gather the mistakes that check.py files declare meanwhile, for whoever writes them."""
    found: list[Mistake] = []
    _noted.append(found)
    try:
        yield found
    finally:
        _noted.remove(found)


def check(title: str, *, hint: int | None = None) -> Callable[[Callable[[Any], object]], Check]:
    """Name a check: the function below it gets a `grader.task.Task` and states expectations.

    title  what is checked, as the learner reads it in the list of checks
    hint   number of the task's hint (0 is the first) that helps if it fails
    """
    if not isinstance(title, str) or not title.strip():
        raise AuthorError(f"check(title) wants a title in quotes; it got {title!r}")

    def register(work: Callable[[Any], object]) -> Check:
        made = Check(title, hint, work)
        if _reading:
            same = [each for each in _reading[-1].checks if each.title == title]
            if same:
                raise AuthorError(f"there are two checks with the title {title!r}")
            _reading[-1].checks.append(made)
        return made

    return register


def function(
    signature: str,
    reference: Callable[..., Any],
    *,
    compare: Compare = exactly,
    mistakes: Sequence[Mistake | tuple[Any, ...]] = (),
    changes: str | None = None,
    cell_cm: float | None = None,
    grid_cm: float | None = None,
    leaves: bool = False,
) -> Function:
    """Declare a function that the learner writes.

    signature  "beam_end(x, y, angle, reading)": its name and how many parameters it takes
    reference  what is right: takes the same arguments and answers
    compare    exactly, near(within, unit), in_any_order, or (expected, got) -> bool
    mistakes   likely slips: (what the learner is told, a function that answers as the slip
               would[, number of the hint that helps])
    changes    name of a parameter: that argument, as it is after the call, is the answer
    cell_cm    the answers are cells of this side [cm]: wrong ones are outlined on the mat
    grid_cm    the answers are grids, a number for each cell of this side [cm]: likewise
    leaves     whether its arguments have to be after the call as they were; the statement says so
    """
    name, parameters = _parsed(signature)
    if changes is not None and changes not in parameters:
        raise AuthorError(f"function({signature!r}): it has no parameter {changes!r} to change")
    if changes is not None and leaves:
        raise AuthorError(f"function({signature!r}) can't both change and leave its arguments")
    if not callable(reference):
        raise AuthorError(f"function({signature!r}) wants a function that gives what is right")
    listed = mistakes_of(mistakes, f"function({signature!r})")
    return Function(name, parameters, reference, compare, listed, changes, cell_cm, grid_cm, leaves)


def scoring(how: str, points: Callable[..., float], *, of: float = 100) -> Scoring:
    """Declare what a run is worth: the score is the mean of the runs that it is handed to.

    how     what counts, in a sentence or two for the learner
    points  (run, map) -> points of a run that ended by itself
    of      the most a run can have; what is more, or less than 0, is cut to it
    """
    if not isinstance(how, str) or not how.strip():
        raise AuthorError(f"scoring(how, points) wants words for the learner; it got {how!r}")
    if not callable(points) or not of > 0:
        raise AuthorError("scoring(how, points, of=…) wants a function of a run and its map")
    return Scoring(how, points, of)


def mistakes_of(mistakes: Sequence[Mistake | tuple[Any, ...]], call: str) -> tuple[Mistake, ...]:
    """The slips as they are written in a check.py, checked."""
    for each in mistakes:
        if isinstance(each, Mistake):
            continue
        sound = (
            isinstance(each, tuple)
            and len(each) in (2, 3)
            and isinstance(each[0], str)
            and callable(each[1])
            and (len(each) == 2 or isinstance(each[2], int))
        )
        if not sound:
            raise AuthorError(
                f"{call} wants each of its mistakes as (what the learner is told, a function), "
                f"with the number of a hint after them if need be; it got {each!r}"
            )
    listed = tuple(each if isinstance(each, Mistake) else Mistake(*each) for each in mistakes)
    for found in _noted:
        found += [each for each in listed if each.text not in {known.text for known in found}]
    return listed


def _parsed(signature: str) -> tuple[str, tuple[str, ...]]:
    try:
        (defined,) = ast.parse(f"def {signature}: pass").body
    except (SyntaxError, ValueError):
        raise AuthorError(
            f'function(signature, …) wants something like "cell_of(x, y)"; it got {signature!r}'
        ) from None
    assert isinstance(defined, ast.FunctionDef)
    return defined.name, tuple(each.arg for each in defined.args.args)


def checks_of(source: str, filename: str) -> list[Check]:
    """Execute a check.py; the checks it names, in their order.

    Whatever goes wrong in it is raised as it is: `grader.judge` knows that it is ours.
    """
    file = _File()
    _reading.append(file)
    try:
        exec(compile(source, filename, "exec", dont_inherit=True), {"__name__": "check"})
    finally:
        _reading.pop()
    if not file.checks:
        raise AuthorError('it names no checks: begin one with @check("…")')
    return file.checks
