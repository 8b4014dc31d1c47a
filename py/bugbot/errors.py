"""The errors a learner may see, and how they are worded.

May import: the standard library only.

    BugbotError               every error of ours; `except BugbotError` catches them all
    ├── WrongTypeError        (TypeError)    an argument of the wrong kind
    ├── WrongValueError       (ValueError)   the right kind, but out of range
    ├── NoRobotError          (RuntimeError) a robot's call outside a run
    ├── NoCameraError         (RuntimeError) position() or heading() in a world without a camera
    ├── NoInputError          (EOFError)     input() in a place without a keyboard
    ├── NoThreadError         (RuntimeError) a thread in a place without threads
    ├── NoNetworkError        (OSError)      asyncio's network, processes and pipes
    ├── StuckError            (RuntimeError) a wait that nothing can end
    └── WorldError            (ValueError)   a world that is unknown or broken

The wording: name the call as it is written in the help, say what it wants, say
what it got: "wait(seconds) wants a number of 0 or more; it got 'a'". No blame,
no jargon, no full stop at the end of a single sentence. What may lie behind the
mistake is not said here: that is the work of `bugbot.run.slips`.
"""

from __future__ import annotations

import re
from difflib import get_close_matches
from reprlib import Repr
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

__all__ = [
    "BugbotError",
    "NoCameraError",
    "NoInputError",
    "NoNetworkError",
    "NoRobotError",
    "NoThreadError",
    "StuckError",
    "WorldError",
    "WrongTypeError",
    "WrongValueError",
    "counted",
    "got",
    "listed",
    "nearest",
    "times",
    "with_article",
]


class BugbotError(Exception):
    """Every error that bugbot raises on purpose."""


class WrongTypeError(BugbotError, TypeError):
    """An argument is of a kind the call can't use."""


class WrongValueError(BugbotError, ValueError):
    """An argument is of the right kind, but its value makes no sense."""


class NoRobotError(BugbotError, RuntimeError):
    """A robot's call was made while no run was going on."""


class NoCameraError(BugbotError, RuntimeError):
    """The program asked for the exact pose, and no camera watches the mat."""


class NoInputError(BugbotError, EOFError):
    """The program asked for typed input, and nobody can type any."""


class NoThreadError(BugbotError, RuntimeError):
    """The program tried to start a thread."""


class NoNetworkError(BugbotError, OSError):
    """The program tried to reach something outside itself."""


class StuckError(BugbotError, RuntimeError):
    """The program waits for something that nobody is there to bring."""


class WorldError(BugbotError, ValueError):
    """A world is unknown, or its file is broken; says which field and what to do."""


_short = Repr()
_short.maxlevel = 2
_short.maxstring = _short.maxother = _short.maxlong = 48


def got(value: object) -> str:
    """A value as an error message shows it: short, and never an error itself.

    >>> got("abc"), got(print), got(None)
    ("'abc'", 'the function print', 'None')
    """
    name = getattr(value, "__name__", None)
    if callable(value) and isinstance(name, str):
        return f"the {'class' if isinstance(value, type) else 'function'} {name}"
    try:
        # Where a thing lies in memory tells nobody anything, and differs from run to run.
        return re.sub(r" at 0x[0-9a-fA-F]+", "", _short.repr(value))
    except Exception:
        return f"something of type {type(value).__name__}"


def with_article(name: str) -> str:
    """A type's name as it is spoken of.

    >>> with_article("IndexError"), with_article("dict"), with_article("OSError")
    ('an IndexError', 'a dict', 'an OSError')
    """
    if name[:2].isupper():  # letter by letter
        vowel = name[0] in "AEFHILMNORSX"
    else:  # an UnboundLocalError, but a UnicodeError and a UserDict
        vowel = name[:1] in tuple("AEIOaeio") or re.match(r"[Uu]n(?!i)", name) is not None
    return f"{'an' if vowel else 'a'} {name}"


def counted(count: int, one: str, many: str | None = None) -> str:
    """So many of something; `many` is its plural where that is not just an s more.

    >>> counted(1, "cell"), counted(1200, "cell"), counted(0, "pass", "passes")
    ('1 cell', '1,200 cells', '0 passes')
    """
    return f"{count:,} {one if count == 1 else many or one + 's'}"


def times(count: int) -> str:
    """How often, in a word where there is one.

    >>> times(1), times(2), times(3)
    ('once', 'twice', '3 times')
    """
    return {1: "once", 2: "twice"}.get(count, f"{count} times")


def listed(texts: Sequence[str]) -> str:
    """Texts one after the other, as in a sentence.

    >>> listed(["x"]), listed(["x", "y"]), listed(["x", "y", "z"])
    ('x', 'x and y', 'x, y and z')
    """
    return " and ".join([", ".join(texts[:-1]), texts[-1]] if len(texts) > 1 else texts)


def nearest(word: str, known: Iterable[str]) -> str | None:
    """The known word most like this one, or None if none is.

    >>> nearest("foward", ["forward", "backward"])
    'forward'
    """
    folded = {each.lower(): each for each in known}
    found = get_close_matches(word.lower(), folded, n=1, cutoff=0.7)
    return folded[found[0]] if found else None
