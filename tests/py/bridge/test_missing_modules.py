"""What a program imports is known before it runs."""

import pytest

from bridge.imports import missing_modules


@pytest.mark.parametrize(
    ("program", "missing"),
    [
        ("", []),
        ("x = 1\n", []),
        ("import math\nfrom bugbot import *\n", []),
        ("import ast as tree  # loaded already\n", []),
        ("import nothing_1\n", ["nothing_1"]),
        ("from nothing_1.part import thing\n", ["nothing_1"]),
        ("import math, nothing_1\n", ["nothing_1"]),
        ("x = 1; import nothing_1\n", ["nothing_1"]),
        ("if True: import nothing_1\n", ["nothing_1"]),
        ("from \\\nnothing_1 \\\nimport math\n", ["nothing_1"]),
        ("from \\\r\nnothing_1 \\\r\nimport math\r\n", ["nothing_1"]),
        (
            "def f():\n    try:\n        import nothing_1\n    except ImportError:\n        pass\n",
            ["nothing_1"],
        ),
        ("import math.nothing\n", ["math"]),
        ("import nothing_1\nimport nothing_2\nimport nothing_1\n", ["nothing_1", "nothing_2"]),
        ('"""A text:\nimport nothing_1\n"""\n', []),
        ("import nothing_1 and what is no Python\n", []),
        ("# import nothing_1\n", []),
        ("from . import nothing_1\n", []),
    ],
)
def test_missing_modules(program: str, missing: list[str]) -> None:
    assert missing_modules(program) == missing


def test_a_long_line_takes_no_long_time() -> None:
    """Beyond a quarter of a million spaces, a pattern that looks twice would look for hours."""
    spaces = " " * 300_000
    for line in (f"from math import sin{spaces}!", f"import math{spaces}as{spaces}!"):
        assert missing_modules(line) == []
