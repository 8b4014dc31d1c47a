"""Two names that are nearly the same: which of them is the slip, as far as one can see.

May import: the standard library, the rest of `bugbot.run.slips`.
"""

from __future__ import annotations

from types import ModuleType

from bugbot.run.slips.case import Case

__all__ = ["is_own", "meant", "two_spellings"]

_MOST_LINES = 3

_MOST_LETTERS = 2
"""Of two names that differ in length by more letters none is likely to be the other."""


def is_own(value: object) -> bool:
    """Whether the program itself may have chosen the name that holds this value."""
    home = getattr(value, "__module__", None) if callable(value) else None
    return not isinstance(value, ModuleType) and home in (None, "__main__")


def two_spellings(case: Case, near: str, name: str, quoted: bool = False) -> str:
    """What to say of a name that is not there, and one of the program's own that is.

    The slip may as well be in the line that gives the value: nobody is told to copy it.
    """
    of_near, of_name = case.lines_with(near, quoted), case.lines_with(name, quoted)
    shown = (repr(near), repr(name)) if quoted else (near, name)
    if not of_near or not of_name or abs(len(near) - len(name)) > _MOST_LETTERS:
        return f"Did you mean {shown[0]}?"
    return (
        f"It is spelt {shown[0]} on {_lines(of_near)} and {shown[1]} on {_lines(of_name)}: make "
        "them the same."
    )


def meant(near: str, name: str) -> str:
    """What to say where only one of the two can be right."""
    letters = " Capital and small letters count." if near.lower() == name.lower() else ""
    return f"Did you mean {near}?{letters}"


def _lines(numbers: list[int]) -> str:
    first = [str(each) for each in numbers[:_MOST_LINES]]
    if len(first) == 1:
        return f"line {first[0]}"
    return f"lines {', '.join(first[:-1])} and {first[-1]}"
