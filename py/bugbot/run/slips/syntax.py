"""Slips in what can't be read as Python: brackets, quotes, colons, indentation.

May import: the standard library, the rest of `bugbot.run.slips`.
"""

from __future__ import annotations

import keyword
import re

from bugbot.run.slips.case import Case, Slip

__all__ = ["SLIPS"]

_BLOCK_WITH_BRACE = r"^\s*(if|for|while|def|else)\b.*\{\s*$"
_NO_BRACES = "Python puts no { } round a block: a colon and an indent do it."

_FOREIGN: tuple[tuple[str, str], ...] = (
    (r"\belse\s+if\b", "Python writes else if as one word: elif."),
    (r"^\s*(elseif|elsif)\b", "Python's word for this is elif."),
    (r"&&", "Python writes && as the word and."),
    (r"\|\|", "Python writes || as the word or."),
    (r"!(?!=)", "Python writes ! as the word not."),
    (r"\+\+|--", "Python has no ++ or --: write x += 1 or x -= 1."),
    (r"^\s*function\b", "Python defines a function with def: def name():"),
    (r"^\s*(var|let|const|int|float)\s+\w+\s*=", "Python needs no word before a new name: x = 3"),
    (r"^\s*for\s*\(|^\s*for\s+\w+\s*=", "Python counts like this: for i in range(10):"),
    (
        r"^\s*for\s+\w+\s+\w+\s+in\b",
        "Between the names there must be a comma: for angle, distance_cm in scan():",
    ),
    (
        r"\b(?:and|or)\s*(?:[<>]=?|[!=]=)",
        "Each side of and and or needs both its values: d > 20 and d < 200",
    ),
    (r"\bthen\s*:?\s*$", "Python has no then: the line ends with a colon."),
    (r"\bdo\s*:?\s*$", "Python has no do: the line ends with a colon."),
    (rf"{_BLOCK_WITH_BRACE}|^\s*\}}", _NO_BRACES),
)
"""Pattern in the line -> hint: what other languages write, whatever Python says of it."""

_UNREADABLE: tuple[tuple[str, str], ...] = (
    (
        r"^\s*(class|from|import|in|is|lambda|pass|global|with|as|del|not|and|or|if|for|while"
        r"|return|try|def)\s*=",
        "That name is one of Python's own words: choose another for your value.",
    ),
    (
        r"^\s*(wait|turn|forward|backward|left|right|beep|plot|led|drive|draw)\s+[-\w\"']",
        "A call needs brackets round what it is given: wait(2)",
    ),
    (r"^\s*(else|elif|except|finally)\b", "This has no if (or try) above it at the same indent."),
    (r"(?<![=!<>])=\s*$|[-+*/%]\s*$", "The line stops too early: something is missing at its end."),
)
"""Pattern in the line -> hint, where Python only says that it can't read it."""

_BY_MESSAGE: tuple[tuple[str, str], ...] = (
    (r"^'(.)' was never closed", "This {0} is never closed: add its partner where it should end."),
    (r"^unmatched '(.)'", "There is a {0} too many, or its opening partner is missing."),
    (
        r"^closing parenthesis '(.)' does not match opening parenthesis '(.)'",
        "What was opened with {1} is closed with {0}: make them a pair.",
    ),
    (
        r"Maybe you meant '==' or ':='",
        "A question is asked with two equals signs: ==. One alone gives a value to a name.",
    ),
    (
        r"^cannot assign to (function call|literal|expression)",
        "The name that gets the value stands on the left of =: x = 3. To compare, write ==.",
    ),
    (r"^cannot assign to (True|False|None)", "{0} is a fixed value: choose another name."),
    (
        r"^unterminated triple-quoted",
        "A text that begins with three quotes must end with three quotes.",
    ),
    (
        r"^unterminated (f-)?string",
        "A quote is missing at the end of the text, or the text holds one like those around it.",
    ),
    (r"f-string", "In an f-text each {{ needs its }} with something in between."),
    (r"^expected ':'", "A line that begins a block (if, for, while, def …) ends with a colon."),
    (
        r"^expected an indented block after (.+?) on line (\d+)",
        "What belongs to the {0} on line {1} must be there, indented by 4 spaces.",
    ),
    (
        r"^unexpected indent",
        "This line begins further right than the one above, which does not open a block.",
    ),
    (
        r"^unindent does not match",
        "This line begins between two levels: line it up with the block that it belongs to.",
    ),
    (
        r"^inconsistent use of tabs",
        "Some lines are indented with tabs and some with spaces: use 4 spaces everywhere.",
    ),
    (r"^Missing parentheses in call to '(\w+)'", "Put brackets round it: {0}(…)"),
    (r"^'(return|yield|await)' outside", "{0} belongs inside a function: check the indentation."),
    (r"^'(break|continue)' ", "{0} belongs inside a loop: check the indentation."),
    (r"forgot a comma", "Between two values there must be a comma."),
    (r"^leading zeros", "A number does not begin with 0: write 7, not 007."),
    (
        r"^invalid decimal literal",
        "A number runs into letters: units like cm are not written, a name can't begin with a "
        "digit, and to multiply write *: 2 * x.",
    ),
    (
        r"^positional argument follows keyword",
        "Arguments with a name (size=2) come after those without.",
    ),
    (r"^expected '\('", "def needs brackets after the function's name, even empty: def name():"),
    (r"^':' expected after dictionary key", "Each entry of a dictionary is key: value."),
    (r"^expected 'except' or 'finally'", "try needs an except below it, at the same indent."),
    (r"names? after 'import'", "Say what to import: from bugbot import *"),
    (r"assigned to before global", "The global line must come first in the function."),
    (r"duplicate argument '(\w+)'", "Two arguments are called {0}: each needs its own name."),
    (r"line continuation", "There is a \\ in the line: outside a text it is of no use here."),
    (r"null bytes", "There are unreadable characters in the program: type it anew."),
)
"""Pattern in Python's message -> hint."""


def _foreign(case: Case) -> str | None:
    return next((hint for pattern, hint in _FOREIGN if re.search(pattern, case.code)), None)


def _unreadable(case: Case) -> str | None:
    if case.message != "invalid syntax":
        return None
    return next((hint for pattern, hint in _UNREADABLE if re.search(pattern, case.code)), None)


def _by_message(case: Case) -> str | None:
    for pattern, hint in _BY_MESSAGE:
        found = re.search(pattern, case.message)
        if found:
            return hint.format(*found.groups())
    return None


def _sign_missing(case: Case) -> str | None:
    """`(column + 0.5) CELL`: it can be read once a * stands between the two."""
    if not case.message.startswith("invalid syntax"):
        return None
    for found in re.finditer(r"([)\]]|\b\w+)(\s*)(?=([A-Za-z_]\w*)\b)", case.text):
        before, space, after = found[1], found[2], found[3]
        glued = not space and before not in (")", "]")
        if glued or {before, after} & {*keyword.kwlist, *keyword.softkwlist}:
            continue
        text = f"{case.text[: found.end()]} * {case.text[found.end() :]}"
        if case.is_read(text):
            comma = ": a comma? " if "forgot a comma" in case.message else ". "
            product = {")": "(…)", "]": "[…]"}.get(before, before)
            return (
                f"Between {before} and {after} something is missing{comma}To multiply write *: "
                f"{product} * {after}"
            )
    return None


def _brace_above(case: Case) -> str | None:
    """`if x {` and then a sound line: Python complains of the second."""
    above = "" if case.line is None else case.text_of(case.line - 1)
    return _NO_BRACES if re.match(_BLOCK_WITH_BRACE, above) else None


def _only_syntax(slip: Slip) -> Slip:
    return lambda case: slip(case) if isinstance(case.error, SyntaxError) else None


SLIPS: tuple[Slip, ...] = tuple(
    map(_only_syntax, (_foreign, _brace_above, _unreadable, _sign_missing, _by_message))
)
