"""JSON that an instructor wrote, held against its schema, with the line of whatever is wrong.

May import: the standard library.

lessons/lesson.schema.json is the one statement of what a lesson.json holds. This knows the part of
JSON Schema that it uses, and refuses a schema that uses more, so that no rule is there in vain.
"""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from typing import Any

__all__ = ["Document", "read"]

Path = tuple[str | int, ...]

_TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|[{}\[\],:]|[^\s{}\[\],:"]+')
_KINDS: dict[str, Any] = {
    "object": dict,
    "array": list,
    "string": str,
    "integer": int,
    "boolean": bool,
}
_WORDS = frozenset(
    (
        *("$schema", "title", "description", "type", "const", "required", "properties"),
        *("additionalProperties", "patternProperties", "items", "minItems", "maxItems"),
        *("uniqueItems", "minLength", "pattern", "minimum", "maximum"),
    )
)


@dataclass(frozen=True, slots=True)
class Document:
    """A JSON text: its data, and what is wrong with it as (line, sentence).

    data is None where the text is not JSON at all.
    """

    data: Any
    faults: list[tuple[int, str]]
    lines: dict[Path, int]

    def line_of(self, *path: str | int) -> int:
        """The line on which the value at a path stands, or of what it would be in."""
        while path and path not in self.lines:
            path = path[:-1]
        return self.lines.get(path, 1)


def read(text: str, schema: dict[str, Any]) -> Document:
    """Read a JSON text and hold it against a schema."""
    try:
        data = json.loads(text)
    except json.JSONDecodeError as error:
        words = f"this is not JSON: {error.msg}; a comma, a quote or a bracket is wrong here"
        return Document(None, [(error.lineno, words)], {})
    lines = _lines(text)
    document = Document(data, [], lines)
    for path, fault in _faults(data, schema, ()):
        document.faults.append((document.line_of(*path), f"{_shown(path)} {fault}"))
    return document


def _shown(path: Path) -> str:
    text = "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in path)
    return text.removeprefix(".") or "the file"


# -- where values stand ----------------------------------------------------------


def _lines(text: str) -> dict[Path, int]:
    """Path -> line, of a text that is known to be JSON."""
    tokens = [
        (match.group(), text.count("\n", 0, match.start()) + 1) for match in _TOKEN.finditer(text)
    ]
    lines: dict[Path, int] = {}
    at = 0

    def value(path: Path) -> None:
        nonlocal at
        token, line = tokens[at]
        lines[path] = line
        at += 1
        if token not in ("{", "["):
            return
        index = 0
        while tokens[at][0] not in ("}", "]"):
            if token == "{":
                key = json.loads(tokens[at][0])
                at += 2
            else:
                key = index
                index += 1
            value((*path, key))
            if tokens[at][0] == ",":
                at += 1
        at += 1

    value(())
    return lines


# -- the schema ------------------------------------------------------------------


def _faults(data: Any, schema: dict[str, Any], path: Path) -> list[tuple[Path, str]]:
    unknown = schema.keys() - _WORDS
    if unknown:
        raise ValueError(f"the schema uses {', '.join(sorted(unknown))}, which is not known here")
    if "const" in schema and data != schema["const"]:
        return [(path, f"is {data!r}; it should be {schema['const']!r}")]
    kind = schema.get("type")
    if kind is not None and not _is(data, kind):
        return [(path, f"should be {_article(kind)}; it is {json.dumps(data)[:60]}")]
    if isinstance(data, dict):
        return _in_object(data, schema, path)
    if isinstance(data, list):
        return _in_list(data, schema, path)
    return [(path, fault) for fault in _of_plain(data, schema)]


def _is(data: Any, kind: str) -> bool:
    return isinstance(data, _KINDS[kind]) and (kind == "boolean" or not isinstance(data, bool))


def _article(kind: str) -> str:
    return {"string": "a text", "array": "a list", "boolean": "true or false"}.get(
        kind, f"an {kind}"
    )


def _in_object(data: dict[str, Any], schema: dict[str, Any], path: Path) -> list[tuple[Path, str]]:
    properties = schema.get("properties", {})
    patterns = schema.get("patternProperties", {})
    faults: list[tuple[Path, str]] = [
        (path, f"lacks {name!r}: add it") for name in schema.get("required", ()) if name not in data
    ]
    for name, each in data.items():
        rules = [properties[name]] if name in properties else []
        rules += [rule for pattern, rule in patterns.items() if re.search(pattern, name)]
        if not rules and schema.get("additionalProperties") is False:
            known = ", ".join(properties) or "names in small letters, digits and hyphens"
            faults.append(((*path, name), f"is not known here; known are {known}"))
        for rule in rules:
            faults += _faults(each, rule, (*path, name))
    return faults


def _in_list(data: list[Any], schema: dict[str, Any], path: Path) -> list[tuple[Path, str]]:
    faults: list[tuple[Path, str]] = []
    fewest, most = schema.get("minItems", 0), schema.get("maxItems", len(data))
    if not fewest <= len(data) <= most:
        wanted = f"{fewest}" if fewest == most else f"at least {fewest}"
        faults.append((path, f"should have {wanted} item{'s' * (fewest != 1)}; it has {len(data)}"))
    if schema.get("uniqueItems") and len({json.dumps(each) for each in data}) < len(data):
        faults.append((path, "says the same twice"))
    for index, each in enumerate(data):
        faults += _faults(each, schema.get("items", {}), (*path, index))
    return faults


def _of_plain(data: Any, schema: dict[str, Any]) -> list[str]:
    faults = []
    if isinstance(data, str):
        if len(data.strip()) < schema.get("minLength", 0):
            faults.append("is empty")
        pattern = schema.get("pattern")
        if pattern is not None and not re.search(pattern, data):
            faults.append(f"is {data!r}, which does not fit {pattern}")
    elif isinstance(data, int):
        low, high = schema.get("minimum", data), schema.get("maximum", data)
        if not low <= data <= high:
            faults.append(f"is {data}; it should be {low} or more, and at most {high}")
    return faults
