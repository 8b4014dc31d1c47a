"""What a call did not do as it was told is noted, once a line, and nothing else changes."""

from collections.abc import Callable
from typing import Any

import pytest

from bugbot.cli import main

Run = Callable[..., Any]


@pytest.mark.parametrize(
    ("call", "argument", "most"),
    [
        ("forward(500)", "speed 500", "100"),
        ("forward(-101)", "speed -101", "-100"),
        ("backward(200, distance=1)", "speed 200", "100"),
        ("left(100.5)", "speed 100.5", "100"),
        ("right(1e6)", "speed 1e+06", "100"),
        ("turn(90, 150)", "speed 150", "100"),
        ("drive(120, 0, 0)", "forward 120", "100"),
        ("drive(0, -120, 0)", "right -120", "-100"),
        ("drive(0, 0, 120)", "turn 120", "100"),
        ("connect().forward(500)", "speed 500", "100"),
    ],
)
def test_a_speed_beyond_the_fastest_is_noted(
    run_calls: Run, call: str, argument: str, most: str
) -> None:
    ran = run_calls(f"\nfor _ in range(3):\n    {call}")
    (note,) = ran.notes
    assert note["line"] == 3
    assert note["text"].endswith(
        f" got {argument}, and the robot can't go faster than 100 per cent: it counts as {most}"
    )
    assert ran.console == ""


def test_no_note_without_a_reason(run_calls: Run) -> None:
    ran = run_calls("""
        forward(100, distance=5)
        backward(-100, distance=2)
        turn(-90, 100)
        drive(-100, 100, 100)
    """)
    assert ran.notes == []


def test_the_same_run_but_for_the_note(run_calls: Run) -> None:
    clamped = run_calls("forward(500)\nwait(2)\nprint(scan())")
    plain = run_calls("forward(100)\nwait(2)\nprint(scan())")
    assert [each for each in clamped.trace.events if each[0] != "note"] == plain.trace.events


def test_a_stop_short_is_noted_with_what_was_touched_and_where(
    run_calls: Run, make_world: Callable[..., Any]
) -> None:
    ran = run_calls("forward(50, distance=300)", make_world((90, 150, 30, 10)))
    assert ran.notes == [
        {
            "line": 2,
            "text": "the robot drove 45.0 cm and not 300: it touched the box 0 at (100.0, 150.0)",
        }
    ]
    ran = run_calls("backward(50, distance=300)")
    assert ran.notes[0]["text"] == (
        "the robot drove 95.0 cm and not 300: it touched the wall round the mat at (100.0, 0.0)"
    )


def test_driving_up_to_what_is_there_is_no_stop_short(
    run_calls: Run, make_world: Callable[..., Any]
) -> None:
    assert run_calls("forward(50, distance=45)", make_world((90, 150, 30, 10))).notes == []


def test_a_run_has_only_so_many_notes(run_calls: Run) -> None:
    assert len(run_calls("\n".join(["forward(500)"] * 50)).notes) == 20


def test_the_command_line_shows_notes_where_they_came(
    tmp_path: Any, capfd: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "fast.py"
    file.write_text("from bugbot import *\nprint('go', end='')\nforward(500)\nprint('gone')\n")
    assert main(["run", str(file)]) == 0
    out, err = capfd.readouterr()
    assert out == "gogone\n"
    assert err.splitlines()[1].startswith("Line 3: forward(speed, distance) got speed 500")
