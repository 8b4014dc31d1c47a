"""What there is of layers or lines, and which of them was perhaps meant.

May import: the standard library, `bugbot.errors`.
"""

from __future__ import annotations

from collections.abc import Iterable

from bugbot.errors import listed, nearest

__all__ = ["perhaps_meant", "what_there_is"]


def what_there_is(one: str, many: str, names: Iterable[str]) -> str:
    """The names of what there is, in a sentence.

    >>> what_there_is("layer", "layers", ["free", "goal"])
    'the layers are "free" and "goal"'
    """
    quoted = [f'"{each}"' for each in names]
    if not quoted:
        return f"there is no {one}"
    if len(quoted) == 1:
        return f"the only {one} is {quoted[0]}"
    return f"the {many} are {listed(quoted)}"


def perhaps_meant(one: str, name: str, names: Iterable[str]) -> str | None:
    """The cause, if one of the names is nearly the one that is wanted."""
    near = nearest(name, names)
    return f'perhaps your {one} "{near}" is meant: call it "{name}"' if near else None
