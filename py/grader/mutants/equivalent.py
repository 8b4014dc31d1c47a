"""equivalent.json: the changes of a task's solution that are no mistakes, each with its reason.

May import: the standard library, `grader.lesson`, `grader.mutants.mutants`, `grader.schema`.

    [{"in": "add_beam", "change": "step = CELL / 2 -> step = 2.5", "why": "…"},
     {"in": "explore", "change": "SPARE * -> *", "kinds": ["number"], "why": "…"}]

`in` is the function ("" outside all of them; left out, it may be any), `change` the lines before
and after as the report shows them, where * stands for any text; left out, it is any change.
`kinds` are those of the report. `number` says which, if the same change is possible in several
places. An entry that explains no mutant which passes is a fault, so that no reason outlives its
code.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from grader.lesson import Fault
from grader.mutants.mutants import Mutant
from grader.schema import read

__all__ = ["FILE", "Entry", "entries_of", "explained"]

FILE = "equivalent.json"

_SCHEMA = {
    "type": "array",
    "items": {
        "type": "object",
        "required": ["why"],
        "additionalProperties": False,
        "properties": {
            "in": {"type": "string"},
            "change": {"type": "string", "minLength": 1},
            "kinds": {"type": "array", "minItems": 1, "items": {"type": "string"}},
            "number": {"type": "integer", "minimum": 1},
            "why": {"type": "string", "minLength": 15},
        },
    },
}


@dataclass(frozen=True, slots=True)
class Entry:
    """A change or a family of them, and why it is no mistake."""

    function: str | None
    change: str | None
    kinds: tuple[str, ...]
    number: int | None
    why: str
    line: int
    """Where the entry begins in its file."""

    def fits(self, mutant: Mutant) -> bool:
        """Is this one of the changes that are meant?"""
        return (
            self.function in (None, mutant.function)
            and (not self.kinds or mutant.kind in self.kinds)
            and self.number in (None, mutant.number)
            and (self.change is None or _like(self.change, mutant.change))
        )


def entries_of(folder: Path) -> tuple[list[Entry], list[Fault]]:
    """The entries of a task's folder, and what is wrong with them as they stand."""
    path = folder / FILE
    if not path.exists():
        return [], []
    document = read(path.read_text("utf-8"), _SCHEMA)
    faults = [Fault(path, line, what) for line, what in document.faults]
    if faults:
        return [], faults
    entries = []
    for place, data in enumerate(document.data):
        line = document.line_of(place)
        entries.append(_entry(data, line))
        if "in" not in data and "change" not in data:
            words = "say which change is meant: give `in`, `change` or both"
            faults.append(Fault(path, line, words))
    return entries, faults


def explained(
    folder: Path, entries: list[Entry], every: list[Mutant], passing: list[Mutant]
) -> tuple[dict[Mutant, str], list[Fault]]:
    """Of the mutants that pass, those with a reason; and the entries that explain none.

    every  the mutants of the task, to say whether there is such a change in the first place
    """
    reasons = {
        mutant: entry.why for entry in reversed(entries) for mutant in passing if entry.fits(mutant)
    }
    faults = []
    for entry in entries:
        if any(entry.fits(mutant) for mutant in passing):
            continue
        known = any(entry.fits(mutant) for mutant in every)
        words = (
            "the checks notice this change" if known else "no change of the solution is like this"
        )
        faults.append(Fault(folder / FILE, entry.line, f"{words}: remove the entry"))
    return reasons, faults


def _entry(data: dict[str, Any], line: int) -> Entry:
    kinds = tuple(data.get("kinds", ()))
    return Entry(data.get("in"), data.get("change"), kinds, data.get("number"), data["why"], line)


def _like(pattern: str, text: str) -> bool:
    return re.fullmatch(".*".join(map(re.escape, pattern.split("*"))), text) is not None
