"""Wrong numbers of arguments, in plain words.

May import: the standard library, `bugbot.api`, `bugbot.errors`, the rest of `bugbot.run.slips`.

Python says "drive() missing 2 required positional arguments: 'right' and 'turn'".
"""

from __future__ import annotations

import re
from collections.abc import Callable
from inspect import signature

from bugbot import api
from bugbot.errors import listed
from bugbot.run.slips.case import CALLS, Case

__all__ = ["plain_arguments"]


def plain_arguments(case: Case) -> str | None:
    """The message for a robot's call with too many or too few arguments, or None."""
    found = re.match(r"(?:\w+\.)?(\w+)\(\) (.*)", case.message)
    if not isinstance(case.error, TypeError) or not found or found[1] not in CALLS:
        return None
    name, complaint = found[1], found[2]
    function: Callable[..., object] = getattr(api, name)
    # A function of the learner's own may have the same name; a method of Robot is the same one.
    if case.scope.get(name, function) is not function:
        return None
    parameters = signature(function).parameters.values()
    wanted = [each.name for each in parameters]
    needed = [each.name for each in parameters if each.default is each.empty]
    call = f"{name}({', '.join(wanted)})"
    quoted = re.findall(r"'(\w+)'", complaint)
    if complaint.startswith("missing"):
        verb = "is" if len(quoted) == 1 else "are"
        return f"{call} wants {_count(len(needed))}; {listed(quoted)} {verb} missing"
    if "unexpected keyword" in complaint:
        return f"{call} has no argument called {quoted[0]}"
    if "multiple values" in complaint:
        return f"{call} got {quoted[0]} twice: once by its place and once by its name"
    given = re.search(r"but (\d+) (?:was|were) given", complaint)
    most = "at most " if len(needed) < len(wanted) else ""
    return f"{call} wants {most}{_count(len(wanted))}; it got {given[1]}" if given else None


def _count(arguments: int) -> str:
    if arguments == 0:
        return "no arguments"
    return f"{arguments} argument{'s' if arguments > 1 else ''}"
