"""Slips that come along with copied text: invisible signs, other alphabets, prompts, commands.

May import: the standard library, the rest of `bugbot.run.slips`.
"""

from __future__ import annotations

import re
import unicodedata

from bugbot.run.slips.case import Case, Slip

__all__ = ["SLIPS", "alike", "skeleton"]

_PROMPT = (
    "Leave out the {0} at the start of the line: it is {1}'s prompt, not a part of the program."
)
_TERMINAL = (
    "This is a command for a terminal, not Python: leave the line out. Nothing can be installed "
    "here, and bugbot, NumPy and Python's own library are there already."
)

_LINES: tuple[tuple[str, str], ...] = (
    (r"^\s*```", "Leave out the lines with ```: they belong to the page it was copied from."),
    (r"^\s*(>>>)", _PROMPT.format("{0}", "Python")),
    (r"^\s*(\.\.\.)\s+\S", _PROMPT.format("{0}", "Python")),
    (r"^\s*((?:In|Out)\s?\[[\d ]*\]\s?:)", _PROMPT.format("{0}", "a notebook")),
    (r"^\s*[!%]\s*(?:pip|conda)\b|^\s*!\s*\w+\s+\w", _TERMINAL),
    (
        r"^\s*(%%?\s*[a-z]\w*)",
        "{0} is a command of a notebook, not Python: leave the line out.",
    ),
    (r"^\s*(?:[$]\s|(?:sudo|pip3?|conda|mamba|apt|apt-get|brew|npm)\s+[\w-])", _TERMINAL),
    (r"^\s*(?:python3?|py|cd|mkdir)\s+[\w./-]", _TERMINAL),
)
"""What a line begins with -> hint. A line that is sound Python is never looked at."""

_LOOKALIKES = {
    "“": '"',
    "”": '"',
    "„": '"',
    "«": '"',
    "»": '"',
    "‘": "'",
    "’": "'",
    "´": "'",
    "−": "-",
    "–": "-",
    "—": "-",
    "×": "*",
    "·": "*",
    "÷": "/",
    "≤": "<=",
    "≥": ">=",
    "≠": "!=",
    "…": "...",
}

_LETTERS = str.maketrans(
    "авсеһіјкмпоԛрѕтухѡѵАВСЕНІЈКМОРЅТУХѴαγικνορτυχΑΒΕΖΗΙΚΜΝΟΡΤΥΧ",
    "abcehijkmnoqpstyxwvABCEHIJKMOPSTYXVayiKvoptuxABEZHIKMNOPTYX".replace("K", "k", 1),
)
"""Cyrillic and Greek letters that look like Latin ones."""


def skeleton(word: str) -> str:
    """The word as it looks: letters of other alphabets become the Latin ones they look like."""
    return word.translate(_LETTERS)


def alike(case: Case, name: str, other: str) -> str | None:
    """What to say of two names that look the same and are not; None if they look different."""
    if name == other or skeleton(name) != skeleton(other):
        return None
    strange = name if not name.isascii() else other
    letters = [letter for letter in strange if not letter.isascii()]
    lines = case.lines_with(strange)
    where = f" on line {lines[0]}" if lines else ""
    return (
        f"Two names look the same but are not: in {strange}{where} the {letters[0]} is a "
        f"{_name_of(letters[0])}. Type the name again there."
    )


def _name_of(character: str) -> str:
    name = unicodedata.name(character, "nameless").lower()
    return re.sub(r"^(cyrillic|greek|latin)", lambda found: found[1].capitalize(), name)


def _strange_character(case: Case) -> str | None:
    found = re.match(r"invalid (?:character|non-printable character).*U\+([0-9A-F]+)", case.message)
    if not found:
        return None
    character = chr(int(found[1], 16))
    place = case.text.find(character) + 1
    where = f"at position {place} of the line" if place else "in the line"
    plain = _LOOKALIKES.get(character) or unicodedata.normalize("NFKC", character)
    if unicodedata.category(character) in ("Zs", "Zl", "Zp"):
        return (
            f"There is a {_name_of(character)} {where}, a space of a special kind as web pages "
            "have it: delete it and type a space."
        )
    if unicodedata.category(character) in ("Cf", "Cc", "Co", "Cn", "Mn"):
        return (
            f"There is an invisible character {where}, a {_name_of(character)} "
            f"(U+{ord(character):04X}): delete it, or type the line again."
        )
    if plain != character and plain.isascii():
        return f"{character} is not the sign on the keyboard: write {plain} instead."
    return f"Python has no sign {character}: units and the like are left out, or go in a comment."


def _foreign_letter(case: Case) -> str | None:
    """`fоr i in …` with a Cyrillic о: the word is no word of Python's."""
    if not isinstance(case.error, SyntaxError):
        return None
    for word in re.findall(r"\w+", case.code):
        if not word.isascii() and skeleton(word).isascii() and re.search("[A-Za-z]", word):
            letter = next(each for each in word if not each.isascii())
            return (
                f"In {word} the {letter} is a {_name_of(letter)}, which only looks like the letter "
                "on the keyboard: type the word again."
            )
    return None


def _line_of_something_else(case: Case) -> str | None:
    notebook = isinstance(case.error, NameError) and case.error.name in ("In", "Out")
    if not notebook and not isinstance(case.error, SyntaxError):
        return None
    for pattern, hint in _LINES:
        found = re.search(pattern, case.text)
        if found:
            return hint.format(*found.groups())
    return None


SLIPS: tuple[Slip, ...] = (_strange_character, _line_of_something_else, _foreign_letter)
