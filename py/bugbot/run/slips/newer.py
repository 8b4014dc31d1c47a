"""What a newer Python reads and this one does not.

May import: the standard library, the rest of `bugbot.run.slips`.

The page has a newer Python than a command line may have. A program that is right there is not
called wrong here: it is put as older versions want it, and if it can be read then, that was all.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable

from bugbot.run.slips.case import Case, Slip

__all__ = ["PAGE", "SLIPS"]

PAGE = (3, 14)
"""The version of Python in the page."""


def _newer(case: Case) -> str | None:
    if not isinstance(case.error, SyntaxError) or sys.version_info >= PAGE or case.line is None:
        return None
    for older, advice in _OLDER:
        text = older(case.text)
        if text != case.text and case.is_read(text):
            here = f"{sys.version_info[0]}.{sys.version_info[1]}"
            return (
                f"Python {here} runs this, and can't read it; Python {PAGE[0]}.{PAGE[1]} in the "
                f"page can. {advice}"
            )
    return None


def _other_quotes(text: str) -> str:
    """`f"{d["x"]}"` as `f"{d['x']}"`."""
    changed, quote, depth = [], "", 0
    for at, sign in enumerate(text):
        if not quote:
            if sign in "\"'" and re.search(r"\b[rR]?[fF][rR]?$", text[:at]):
                quote = sign
        elif sign == "{":
            depth += 1
        elif sign == "}":
            depth -= 1
        elif sign == quote and depth > 0:
            sign = "'" if quote == '"' else '"'
        elif sign == quote:
            quote = ""
        changed.append(sign)
    return "".join(changed)


def _group(text: str) -> str:
    """`except A, B:` as `except (A, B):`."""
    return re.sub(r"^(\s*except\*?)\s+([\w.]+(?:\s*,\s*[\w.]+)+)\s*:", r"\1 (\2):", text)


def _plain_type(text: str) -> str:
    """`type Cell = tuple[int, int]` and `def first[T](items: list[T])` without their types."""
    text = re.sub(r"^(\s*)type\s+(\w+)(?:\[[^]]*\])?\s*=", r"\1\2 =", text)
    return re.sub(r"^(\s*(?:async\s+)?(?:def|class)\s+\w+)\[[^]]*\]", r"\1", text)


def _template(text: str) -> str:
    """`t"…"` as `f"…"`."""
    return re.sub(r"\b[tT](?=[\"'])", "f", text)


_OLDER: tuple[tuple[Callable[[str], str], str], ...] = (
    (_other_quotes, "Inside the { } of an f-text use the other kind of quotes: both read that."),
    (_group, "Put the errors in brackets, except (A, B): both read that."),
    (_plain_type, "Leave out the types: both read that."),
    (_template, "A template, t'…', is new: an f-text, f'…', is read by both."),
)
"""How older versions want it, and what to tell."""

SLIPS: tuple[Slip, ...] = (_newer,)
