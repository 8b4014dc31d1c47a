"""The learner's part of a program, and a program put together from a part.

May import: the standard library.

A starter marks the learner's part with two comments. Its text before and after them is given
code. A solution may leave the comments out; then its part is what stands between the same two
texts. A starter without the comments is the learner's from beginning to end.

    before      from bugbot import *
                def cell_of(x, y):
                    # ---- your part ----
    part            return x // 5, y // 5
                    # ---- end of your part ----
    after       print(cell_of(32, 74))
"""

from __future__ import annotations

import re
import tokenize
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from difflib import SequenceMatcher
from io import StringIO

__all__ = [
    "BEGIN",
    "END",
    "Frame",
    "PartError",
    "compose",
    "frame_of",
    "lines_of_part",
    "lines_written",
]

BEGIN = "# ---- your part ----"
END = "# ---- end of your part ----"

_WHOLE = re.compile(r"^(from|import) +bugbot\b", re.MULTILINE)
"""A file with this line is a complete program: the given code has it, so a part needs none."""


class PartError(ValueError):
    """A starter's two comments don't make a part; the message says how."""


@dataclass(frozen=True, slots=True)
class Frame:
    """The given code around the learner's part; each line ends with a line break."""

    before: str
    after: str
    indent: str
    """What every line of the part begins with."""


def frame_of(starter: str) -> Frame | None:
    """The given code of a starter; None if it has no part marked."""
    lines = starter.splitlines(keepends=True)
    begins = [at for at, line in enumerate(lines) if line.strip() == BEGIN]
    ends = [at for at, line in enumerate(lines) if line.strip() == END]
    if not begins and not ends:
        return None
    if len(begins) != 1 or len(ends) != 1 or begins[0] > ends[0]:
        raise PartError(f"a starter has {BEGIN!r} once and, below it, {END!r} once")
    first = lines[begins[0]]
    indent = first[: len(first) - len(first.lstrip())]
    return Frame("".join(lines[: begins[0]]), "".join(lines[ends[0] + 1 :]), indent)


def lines_of_part(starter: str, program: str) -> range:
    """The numbers of the lines of a program that are the learner's part; 1 is the first.

    Empty if the given code around it is not there unchanged, so that nobody can say.
    """
    count = len(program.splitlines())
    frame = frame_of(starter)
    if frame is None:
        return range(1, count + 1)
    own = None if BEGIN not in program else frame_of(program)
    if own is not None:
        begin = own.before.count("\n") + 2
        return range(begin, count - own.after.count("\n"))
    if program.startswith(frame.before) and program.endswith(frame.after):
        first = frame.before.count("\n") + 1
        return range(first, max(first, count - frame.after.count("\n") + 1))
    return range(0)


_MOST_LINES = 2000
"""Longer programs are not gone through for given lines: no person has written them."""


def lines_written(starter: str, program: str) -> AbstractSet[int]:
    """The numbers of the lines that the learner has written; 1 is the first.

    Unlike `lines_of_part` it reads programs, too, whose given code has been changed: the lines
    that are as in the starter are given, and all others count as the learner's.
    """
    lines = program.splitlines()
    try:
        frame = frame_of(starter)
    except PartError:
        frame = None
    if frame is None or len(lines) > _MOST_LINES:
        return set(range(1, len(lines) + 1))
    if program.startswith(frame.before) and program.endswith(frame.after):
        first = frame.before.count("\n") + 1
        return set(range(first, len(lines) - frame.after.count("\n") + 1))
    given = f"{frame.before}{frame.after}".splitlines()
    same = SequenceMatcher(None, given, lines, autojunk=False).get_matching_blocks()
    return set(range(1, len(lines) + 1)) - {
        number for block in same for number in range(block.b + 1, block.b + block.size + 1)
    }


def compose(starter: str, text: str) -> str:
    """The complete program that a text stands for.

    A text with an import of bugbot is complete. Any other is a part: it takes the place of
    the starter's, indented as that is. A starter without a part takes complete programs alone.
    """
    frame = frame_of(starter)
    if frame is None or _WHOLE.search(text):
        return text
    marks = [f"{frame.indent}{BEGIN}\n", f"{frame.indent}{END}\n"]
    return frame.before + _indented(text, frame.indent).join(marks) + frame.after


def _indented(part: str, indent: str) -> str:
    """The part with its own common indentation replaced; lines inside a text are left alone."""
    part = part.replace("\r\n", "\n").strip("\n") + "\n"
    lines = _dedented(part).splitlines(keepends=True)
    inside = _inside_texts("".join(lines))
    return "".join(
        line if number in inside or not line.strip() else indent + line
        for number, line in enumerate(lines, start=1)
    )


def _dedented(part: str) -> str:
    """Without what its lines of code are all indented by; a comment may stand further left."""
    lines = part.splitlines(keepends=True)
    code = next((line for line in lines if line.strip() and not line.lstrip().startswith("#")), "")
    width = len(code) - len(code.lstrip())
    if width == 0:
        return part
    inside = _inside_texts(f"if True:\n{part}")
    return "".join(
        line if number + 1 in inside else line[min(width, len(line) - len(line.lstrip(" \t"))) :]
        for number, line in enumerate(lines, start=1)
    )


def _inside_texts(source: str) -> set[int]:
    """The lines that begin inside a string over several lines."""
    inside: set[int] = set()
    try:
        for token in tokenize.generate_tokens(StringIO(source).readline):
            name = tokenize.tok_name[token.type]
            if name in ("STRING", "FSTRING_MIDDLE") and token.end[0] > token.start[0]:
                inside.update(range(token.start[0] + 1, token.end[0] + 1))
    except (tokenize.TokenError, SyntaxError):
        pass  # it does not read as Python: then the lines are taken as they stand
    return inside
