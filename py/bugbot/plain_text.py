"""Text from elsewhere on its way to a terminal: what would steer the screen is shown instead.

May import: the standard library.

A program's output, its error messages and the name of its file can hold escape codes: they
would move the cursor, change the title, or write over what has been said before.
"""

from __future__ import annotations

import json
import re
from typing import Any

__all__ = ["json_text", "plain"]

_UNPRINTABLE = re.compile(r"[\x7f-\x9f\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff\ud800-\udfff]")
"""What JSON leaves as it is: control characters, invisible ones, halves of characters."""


def plain(text: str, keep: str = "\n\t") -> str:
    r"""The text with every character that is not printed written as its escape; `keep` stays.

    >>> plain("mark\x1b[2J.py")
    'mark\\x1b[2J.py'
    """
    if text.isprintable():
        return text
    return "".join(each if each.isprintable() or each in keep else _escape(each) for each in text)


def _escape(character: str) -> str:
    return character.encode("unicode_escape", "surrogatepass").decode("ascii")


def json_text(data: Any) -> str:
    """The data as JSON that any terminal and any file can take; it reads back the same."""
    text = json.dumps(data, ensure_ascii=False)
    return _UNPRINTABLE.sub(lambda found: f"\\u{ord(found[0]):04x}", text)
