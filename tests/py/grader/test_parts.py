"""The learner's part of a program: found, and put into the given code, as worked out by hand."""

from __future__ import annotations

import pytest

from grader.parts import PartError, compose, frame_of, lines_of_part

STARTER = """from bugbot import *


def double(a):
    # ---- your part ----
    b = 0
    # ---- end of your part ----
    return b


print(double(4))
"""
BARE = STARTER.replace("    # ---- your part ----\n", "").replace(
    "    # ---- end of your part ----\n", ""
)


def test_the_given_code_is_what_stands_around_the_part() -> None:
    frame = frame_of(STARTER)
    assert frame is not None
    assert frame.before.endswith("def double(a):\n")
    assert frame.after == "    return b\n\n\nprint(double(4))\n"
    assert frame.indent == "    "
    assert frame_of(BARE) is None


@pytest.mark.parametrize(
    "starter",
    [
        STARTER.replace("# ---- end of your part ----", ""),
        STARTER.replace("# ---- your part ----", ""),
        STARTER + STARTER,
        "# ---- end of your part ----\n# ---- your part ----\n",
    ],
)
def test_comments_that_make_no_part_are_refused(starter: str) -> None:
    with pytest.raises(PartError, match="once and, below it"):
        frame_of(starter)


def test_the_lines_of_the_part_are_found_with_the_comments_and_without() -> None:
    assert lines_of_part(STARTER, STARTER) == range(6, 7)
    assert lines_of_part(STARTER, BARE.replace("b = 0", "b = a\n    b += a")) == range(5, 7)
    assert lines_of_part(BARE, BARE) == range(1, 10)


def test_a_program_without_the_given_code_has_no_part() -> None:
    assert len(lines_of_part(STARTER, "print(1)\n")) == 0


@pytest.mark.parametrize(
    "part",
    [
        "b = a\nb += a\n",
        "    b = a\n    b += a\n",
        "# style: sum\n    b = a\n    b += a",
        "\n\nb = a\nb += a",
    ],
)
def test_a_part_is_indented_as_the_starters_is(part: str) -> None:
    composed = compose(STARTER, part)
    assert "\n    b = a\n    b += a\n    # ---- end" in composed
    assert composed.endswith("    return b\n\n\nprint(double(4))\n")
    assert composed.startswith("from bugbot import *\n\n\ndef double(a):\n    # ---- your part")


def test_inner_blocks_and_lines_inside_a_text_keep_their_indentation() -> None:
    part = 'if a:\n    b = """one\n  two"""\nelse:\n    b = 1\n'
    assert '    if a:\n        b = """one\n  two"""\n    else:\n        b = 1\n' in compose(
        STARTER, part
    )


def test_an_indented_part_with_a_text_over_several_lines_keeps_it() -> None:
    part = '    b = """one\n  two"""\n    b = 2\n'
    assert '    b = """one\n  two"""\n    b = 2\n' in compose(STARTER, part)


def test_a_complete_program_is_taken_as_it_is() -> None:
    whole = "import bugbot\nprint(bugbot.scan())\n"
    assert compose(STARTER, whole) == whole
    assert compose(BARE, "b = 2\n") == "b = 2\n"


def test_a_part_that_does_not_read_as_python_is_put_in_all_the_same() -> None:
    assert "    b = (\n    # ---- end" in compose(STARTER, "b = (\n")
