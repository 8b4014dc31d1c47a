"""Small damages to files, by chance: what a bad disk, an editor or a joker does to them."""

from __future__ import annotations

import json
from random import Random
from typing import Any

__all__ = ["damaged", "damaged_json"]

_TOKENS = [
    *("", "\0", "\n", " ", "-", "0", "1e999", "-1", "99999999999999999999", "NaN", "null", "true"),
    *(
        '"',
        "[",
        "]",
        "{",
        "}",
        ",",
        ":",
        "[[[[[[[[[[",
        "\ud800",
        "\ufeff",
        "é",
        "🤖",
        "#",
        "|",
        "- ",
    ),
]
_VALUES: list[Any] = [
    *(None, True, False, 0, -1, 1.5, 1e308, -1e308, 10**30, "", "x", "x" * 5000, "\ud800"),
    *([], {}, [[]], [None], {"": None}, [1, "2", None], {"x": {"x": {}}}),
]


def damaged(data: bytes, random: Random) -> bytes:
    """`data` with one to four pieces cut out, doubled, swapped, overwritten or put in."""
    for _ in range(random.randint(1, 4)):
        at = random.randint(0, len(data))
        length = min(random.choice((1, 1, 2, 8, 64, 1024)), len(data) - at)
        piece = data[at : at + length]
        kind = random.randrange(6)
        if kind == 0:
            data = data[:at] + data[at + length :]
        elif kind == 1:
            data = data[:at] + piece + data[at:]
        elif kind == 2:
            data = data[:at] + random.randbytes(length) + data[at + length :]
        elif kind == 3:
            token = random.choice(_TOKENS).encode("utf-8", "surrogatepass")
            data = data[:at] + token + data[at + length :]
        elif kind == 4:
            data = data[:at]
        else:
            to = random.randint(0, len(data))
            data = data[:to] + piece + data[to:]
    return data


def damaged_json(text: str, random: Random) -> str:
    """The same JSON with one value somewhere in it replaced, left out, moved or doubled."""
    data = json.loads(text)
    places: list[tuple[Any, Any]] = []

    def walk(value: Any) -> None:
        pairs = value.items() if isinstance(value, dict) else enumerate(value)
        for key, each in pairs:
            places.append((value, key))
            if isinstance(each, dict | list):
                walk(each)

    walk(data)
    for _ in range(random.randint(1, 2)):
        holder, key = random.choice(places)
        other, other_key = random.choice(places)
        try:
            if random.random() < 0.2:
                del holder[key]
            elif random.random() < 0.3:
                # By way of text, so that no list ends up inside itself.
                holder[key] = json.loads(json.dumps(other[other_key]))
            else:
                holder[key] = random.choice(_VALUES)
        except (KeyError, IndexError):
            continue  # an earlier damage took the place away
    return json.dumps(data)
