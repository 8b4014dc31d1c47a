"""The ways a check ends before its end.

May import: the standard library.
"""

from __future__ import annotations

from typing import Any

__all__ = [
    "ArgumentChanged",
    "AuthorError",
    "CheckFailed",
    "NeedsJob",
    "NotRun",
    "ProgramFailed",
    "ShowingFailed",
]


class CheckFailed(Exception):  # noqa: N818 - a verdict, and no error
    """What was expected is not so.

    expected, got  in words, for the learner
    likely         the mistake it looks like, or None
    hint           number of the hint that helps (0 is the first), or None
    where          {"world", "cells", "cell_cm", "seconds", "job"}, or None
    """

    def __init__(
        self,
        expected: str,
        got: str,
        *,
        likely: str | None = None,
        hint: int | None = None,
        where: dict[str, Any] | None = None,
    ) -> None:
        super().__init__(f"expected {expected}; got {got}")
        self.expected = expected
        self.got = got
        self.likely = likely
        self.hint = hint
        self.where = where

    def but(
        self, *, got: str | None = None, likely: str | None = None, hint: int | None = None
    ) -> CheckFailed:
        """The same failure with something else told of it."""
        return type(self)(
            self.expected,
            self.got if got is None else got,
            likely=self.likely if likely is None else likely,
            hint=self.hint if hint is None else hint,
            where=self.where,
        )


class ArgumentChanged(CheckFailed):
    """A call has changed what it was given: its cause says all, and no hint is about it."""


class ProgramFailed(CheckFailed):
    """The program itself came to grief, whatever this check is about: told once in a mark."""


class ShowingFailed(ProgramFailed):
    """All answers of a check are right, but the program itself did not come to a good end."""


class NeedsJob(BaseException):
    """A check wants the result of a job that is not there yet; no Exception, so none catches it."""


class AuthorError(Exception):
    """A check.py asks for something that makes no sense: our fault, never the learner's."""


class NotRun(Exception):  # noqa: N818 - a verdict, and no error
    """The check could not be made, because of what an earlier one has shown already."""
