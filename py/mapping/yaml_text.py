"""YAML text as far as a ROS map's file goes: the values of its top level, with their lines.

May import: the standard library, `bugbot.errors`, PyYAML (no other module may).

PyYAML's scanner and parser do the reading; what a value means is for `map_yaml` to say, so all
scalars stay text. The page brings PyYAML when a map is opened. A clone of this repository has it
among the packages of the tests; without it a YAML file can't be read, and all else works.

Two of PyYAML's ways are not YAML 1.2's and are put right here: tabs may separate a value from its
name or a comment, and U+0085, U+2028 and U+2029 end no line.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import yaml

from bugbot.errors import WrongValueError, got

__all__ = ["Entry", "top_level"]

MOST_CHARACTERS = 100_000
"""A map's file has some hundred; a longer text is something else."""


@dataclass(frozen=True)
class Entry:
    """A value of the top level.

    value  text, or a list of texts; None where it is neither (a mapping, a list of lists)
    line   where its name stands, from 1
    """

    value: str | list[str] | None
    line: int


def top_level(text: str) -> dict[str, Entry]:
    """Names and values of a YAML text's first document, as readers of ROS maps take it.

    Raises WrongValueError that names the line and says what to do.
    """
    if len(text) > MOST_CHARACTERS:
        raise WrongValueError(f"a map's YAML file has at most {MOST_CHARACTERS:,} characters")
    bare = re.search(r"\r(?!\n)", text)
    if bare:
        raise WrongValueError(
            f"line {text.count(chr(10), 0, bare.start()) + 1} of the map's YAML file ends in a "
            "carriage return alone: save the file with ordinary line ends (LF)"
        )
    root = _first_document(text)
    if not isinstance(root, yaml.MappingNode):
        raise WrongValueError(
            "the map's YAML file has no `name: value` lines: each needs a colon and then a blank"
        )
    found: dict[str, Entry] = {}
    for key, value in root.value:
        if not isinstance(key, yaml.ScalarNode):
            continue
        line = key.start_mark.line + 1
        if key.value in found:
            raise WrongValueError(
                f"line {line} of the map's YAML file gives {key.value} again, after line "
                f"{found[key.value].line}: take one of the two out"
            )
        found[key.value] = Entry(_value(value), line)
    return found


def _first_document(text: str) -> yaml.Node | None:
    try:
        loader = _Loader(_UNUSUAL_BREAKS.sub("\ufffd", text))
        return loader.get_node() if loader.check_node() else None
    except yaml.MarkedYAMLError as error:
        raise WrongValueError(_words(error, text)) from None
    except yaml.reader.ReaderError as error:
        line = text.count("\n", 0, error.position) + 1
        raise WrongValueError(
            f"line {line} of the map's YAML file has the character U+{_code(error.character):04X}, "
            "which YAML forbids: take it out"
        ) from None
    except RecursionError:
        raise WrongValueError("the map's YAML file has lists in lists, too deep to read") from None
    except (ValueError, OverflowError):  # a character that there is not: "\U00ffffff"
        raise WrongValueError("the map's YAML file has a \\ in quotes that can't be read") from None


def _code(character: int | str) -> int:
    return character if isinstance(character, int) else ord(character)


_UNUSUAL_BREAKS = re.compile("[\x85\u2028\u2029]")


class _Loader(yaml.SafeLoader):
    """Tabs separate as blanks do, except in front of a line of block style: there they indent."""

    def scan_to_next_token(self) -> None:
        super().scan_to_next_token()
        while self.peek() == "\t" and not self._indents():
            while self.peek() in "\t ":
                self.forward()
            super().scan_to_next_token()

    def _indents(self) -> bool:
        before = self.buffer[self.pointer - self.column : self.pointer]
        return self.flow_level == 0 and not before.strip()


def _value(node: yaml.Node) -> str | list[str] | None:
    if isinstance(node, yaml.ScalarNode):
        return str(node.value)
    if isinstance(node, yaml.SequenceNode) and all(
        isinstance(each, yaml.ScalarNode) for each in node.value
    ):
        return [str(each.value) for each in node.value]
    return None


def _words(error: yaml.MarkedYAMLError, text: str) -> str:
    """What is wrong with the text, and what to do, for somebody who has never heard of a token."""
    problem = str(error.problem)
    # Where a line is no `name: value`, PyYAML notices only at the next one.
    unnamed = problem.startswith("could not find expected ':'") and error.context_mark
    mark = (error.context_mark if unnamed else error.problem_mark) or error.context_mark
    number = mark.line + 1 if mark else 1
    where = f"line {number} of the map's YAML file"
    lines = text.split("\n")
    line = lines[number - 1].strip() if number <= len(lines) else ""
    if unnamed:
        return f"{where} is no `name: value`: take it out, or write # before it; it is {got(line)}"
    if "\\t" in problem:
        return f"{where} begins with a tab: YAML indents with blanks alone"
    if problem.startswith("mapping values are not allowed"):
        return (
            f"{where} can't be read: it is indented though it belongs to nothing, or a value with "
            f"a colon in it wants quotes; it is {got(line)}"
        )
    if problem.startswith("found character"):
        return f'{where} has a value that wants quotes, as in image: "map.pgm"; it is {got(line)}'
    if "end of stream" in problem:
        return f"{where}: a quote or a bracket is opened and never closed"
    return f"{where} is not YAML ({problem}): put quotes round names; it is {got(line)}"
