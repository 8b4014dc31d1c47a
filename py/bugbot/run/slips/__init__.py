"""The likely causes of an error: which common mistake it looks like.

May import: the standard library, `bugbot.errors`, `bugbot.api`, `bugbot.colours`.

Each module has a tuple `SLIPS` of functions from a `Case` to a sentence or None; the
first that answers is the hint shown under the error. A slip looks only at types,
names and the text of a line: it never runs any of the learner's code.

    case.py       the error, its line and the names in sight there
    copied.py     what comes along with copied text: invisible signs, prompts, commands
    newer.py      what a newer Python reads and this one does not
    syntax.py     what can't be read as Python
    names.py      names that are not there
    attributes.py attributes and keys that are not there
    spelling.py   two names that are nearly the same
    modules.py    modules that are not there
    calls.py      brackets, arguments, functions and what they give back
    values.py     indices, kinds of values
    arithmetic.py sums without an answer, questions that an array can't answer
    arguments.py  wrong numbers of arguments of the robot's calls, in plain words
    quiet.py      programs that end without an error and yet did not do what was meant
"""

from __future__ import annotations

from bugbot.run.slips import (
    arithmetic,
    attributes,
    calls,
    copied,
    modules,
    names,
    newer,
    syntax,
    values,
)
from bugbot.run.slips.case import Case

__all__ = ["likely_cause"]

_ORDER = (
    *copied.SLIPS,
    *newer.SLIPS,
    *syntax.SLIPS,
    *names.SLIPS,
    *attributes.SLIPS,
    *modules.SLIPS,
    *calls.SLIPS,
    *arithmetic.SLIPS,
    *values.SLIPS,
)


def likely_cause(case: Case) -> str | None:
    """What probably went wrong and what to do, or None if this looks like nothing known."""
    try:
        return next((hint for slip in _ORDER if (hint := slip(case)) is not None), None)
    except (
        Exception
    ):  # the program may have broken what looking for a cause needs: sys.modules, say
        return None
