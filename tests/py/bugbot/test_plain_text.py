"""Text from elsewhere can't steer a terminal."""

from __future__ import annotations

import json

import pytest

from bugbot.plain_text import json_text, plain


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("é × 2\n\tas it is", "é × 2\n\tas it is"),
        ("\x1b]0;title\x07", "\\x1b]0;title\\x07"),
        ("a\rb\x08\x9b31m\x7f", "a\\rb\\x08\\x9b31m\\x7f"),
        ("right \u202eto left\u200b", "right \\u202eto left\\u200b"),
        ("\udcff", "\\udcff"),
        ("\U000e0041", "\\U000e0041"),
    ],
)
def test_what_is_not_printed_is_shown(text: str, shown: str) -> None:
    assert plain(text) == shown


def test_json_holds_the_same_and_nothing_that_steers() -> None:
    data = {"got": "\x1b[2J\x9b\u202e\udcff\u2028 é"}
    text = json_text(data)
    assert json.loads(text) == data
    assert text.isprintable()
    assert "é" in text
