"""Wrong arguments: the message of each, and that nothing has happened."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from bugbot import backward, beep, draw, drive, forward, led, left, plot, right, turn, wait
from bugbot.errors import BugbotError, got, nearest
from bugbot.link import Link

NAN, INF = float("nan"), float("inf")
DRIVE = "drive(forward, right, turn) wants a number from -100 to 100 (per cent) for "
DRAW = "draw(name, points, colour, shape, size) wants "
SPEED = "turn(degrees, speed) wants a number above 0 (per cent of full speed) for speed; it got "
LED = "led(colour) or led(red, green, blue) wants "


def some_function() -> None: ...


class Grumpy:
    def __repr__(self) -> str:
        raise RuntimeError


class Plain: ...


class Impostor: ...


Impostor.__name__ = "list"


@pytest.mark.parametrize(
    ("call", "arguments", "kind", "message"),
    [
        (wait, ("a",), TypeError, "wait(seconds) wants a number of 0 or more; it got 'a'"),
        (wait, (None,), TypeError, "wait(seconds) wants a number of 0 or more; it got None"),
        (wait, (True,), TypeError, "wait(seconds) wants a number of 0 or more; it got True"),
        (wait, (1j,), TypeError, "wait(seconds) wants a number of 0 or more; it got 1j"),
        (wait, (np.bool_(True),), TypeError, "wait(seconds) wants a number of 0 or more; it got "),
        (wait, ([1],), TypeError, "wait(seconds) wants a number of 0 or more; it got [1]"),
        (
            wait,
            (some_function,),
            TypeError,
            "wait(seconds) wants a number of 0 or more; it got the function some_function",
        ),
        (
            wait,
            (int,),
            TypeError,
            "wait(seconds) wants a number of 0 or more; it got the class int",
        ),
        (
            wait,
            (Grumpy(),),
            TypeError,
            "wait(seconds) wants a number of 0 or more; it got <Grumpy instance>",
        ),
        (wait, (Plain(),), TypeError, "wait(seconds) wants a number of 0 or more; it got <"),
        (
            wait,
            (Impostor(),),
            TypeError,
            "wait(seconds) wants a number of 0 or more; it got something of type list",
        ),
        (wait, (-0.1,), ValueError, "wait(seconds) wants a number of 0 or more; it got -0.1"),
        (wait, (NAN,), ValueError, "wait(seconds) wants a number of 0 or more; it got nan"),
        (wait, (INF,), ValueError, "wait(seconds) wants a number of 0 or more; it got inf"),
        (wait, (10**400,), ValueError, "wait(seconds) wants a number of 0 or more; it got 1000"),
        (drive, ("a", 0, 0), TypeError, DRIVE + "forward; it got 'a'"),
        (drive, (0, (1, 2), 0), TypeError, DRIVE + "right; it got (1, 2)"),
        (drive, (0, 0, NAN), ValueError, DRIVE + "turn; it got nan"),
        (
            forward,
            ("fast",),
            TypeError,
            "forward(speed, distance) wants a number from -100 to 100 (per cent) for speed; "
            "it got 'fast'",
        ),
        (
            forward,
            (50, -3),
            ValueError,
            "forward(speed, distance) wants a number of 0 or more (cm) for distance; it got -3",
        ),
        (
            backward,
            (50, "3"),
            TypeError,
            "backward(speed, distance) wants a number of 0 or more (cm) for distance; it got '3'",
        ),
        (
            backward,
            (0, 3),
            ValueError,
            "backward(speed, distance) wants a speed other than 0 when it has a distance; "
            "it got speed 0",
        ),
        (
            left,
            (INF,),
            ValueError,
            "left(speed) wants a number from -100 to 100 (per cent); it got inf",
        ),
        (
            right,
            ([],),
            TypeError,
            "right(speed) wants a number from -100 to 100 (per cent); it got []",
        ),
        (
            turn,
            ("90",),
            TypeError,
            "turn(degrees, speed) wants a number of degrees for degrees; it got '90'",
        ),
        (
            forward,
            (5e-324, 3),
            ValueError,
            "forward(speed, distance) wants a speed other than 0 when it has a distance; "
            "it got speed 5e-324",
        ),
        (turn, (90, 5e-324), ValueError, SPEED + "5e-324"),
        (turn, (90, 0), ValueError, SPEED + "0"),
        (turn, (90, -20), ValueError, SPEED + "-20"),
        (turn, (90, None), TypeError, SPEED + "None"),
        (
            draw,
            (3, []),
            TypeError,
            DRAW + "a name in quotes, of 1 to 100 characters, for name; it got 3",
        ),
        (
            draw,
            ("", []),
            ValueError,
            DRAW + "a name in quotes, of 1 to 100 characters, for name; it got ''",
        ),
        (draw, ("x" * 101, []), ValueError, DRAW + "a name in quotes, of 1 to 100 characters"),
        (draw, ("a", 3), TypeError, DRAW + "a list of (x, y) points for points; it got 3"),
        (draw, ("a", "xy"), TypeError, DRAW + "a list of (x, y) points for points; it got 'xy'"),
        (draw, ("a", None), TypeError, DRAW + "a list of (x, y) points for points; it got None"),
        (
            draw,
            ("a", (1, 2)),
            TypeError,
            DRAW + "two numbers (x, y) in each point; point number 0 is 1",
        ),
        (
            draw,
            ("a", [(1, 2), (3,)]),
            TypeError,
            DRAW + "two numbers (x, y) in each point; point number 1 is (3,)",
        ),
        (
            draw,
            ("a", [(1, 2), "ab"]),
            TypeError,
            DRAW + "two numbers (x, y) in each point; point number 1 is 'ab'",
        ),
        (
            draw,
            ("a", [(1, None)]),
            TypeError,
            DRAW + "two numbers (x, y) in each point; point number 0 is (1, None)",
        ),
        (
            draw,
            ("a", [(1, True)]),
            TypeError,
            DRAW + "two numbers (x, y) in each point; point number 0 is (1, True)",
        ),
        (
            draw,
            ("a", [(1, NAN)]),
            ValueError,
            DRAW + "two numbers (x, y) in each point; point number 0 is (1, nan)",
        ),
        (
            draw,
            ("a", [(-INF, 0), (INF, 0)]),
            ValueError,
            DRAW + "two numbers (x, y) in each point; point number 0 is (-inf, 0)",
        ),
        (
            draw,
            ("a", [(10**400, 0)]),
            ValueError,
            DRAW + "two numbers (x, y) in each point; point number 0 is (1000",
        ),
        (
            draw,
            ("a", np.zeros(2)),
            TypeError,
            DRAW + "two numbers (x, y) in each point; point number 0 is 0.0",
        ),
        (
            draw,
            ("a", [(1, 2, "w")]),
            TypeError,
            DRAW + "two numbers (x, y) in each point; point number 0 is (1, 2, 'w')",
        ),
        (
            draw,
            ("a", [(1, 2), ("x", 2, "w")], "red", "text"),
            TypeError,
            DRAW + "two numbers (x, y) in each point; point number 1 is ('x', 2)",
        ),
        (
            draw,
            ("a", [], "gren"),
            ValueError,
            DRAW + "the name of a colour or '#rrggbb' for colour; it got 'gren'; "
            "did you mean 'green'?",
        ),
        (
            draw,
            ("a", [], "#12345"),
            ValueError,
            DRAW + "the name of a colour or '#rrggbb' for colour; it got '#12345'",
        ),
        (
            draw,
            ("a", [], "#12345g"),
            ValueError,
            DRAW + "the name of a colour or '#rrggbb' for colour; it got '#12345g'",
        ),
        (
            draw,
            ("a", [], (255, 0, 0)),
            TypeError,
            DRAW + "the name of a colour or '#rrggbb' for colour; it got (255, 0, 0)",
        ),
        (
            draw,
            ("a", [], "red", "square"),
            ValueError,
            DRAW + "one of 'dots', 'squares', 'line', 'text' for shape; it got 'square'; "
            "did you mean 'squares'?",
        ),
        (
            draw,
            ("a", [], "red", 4),
            TypeError,
            DRAW + "one of 'dots', 'squares', 'line', 'text' for shape; it got 4",
        ),
        (
            draw,
            ("a", [], "red", "dots", 0),
            ValueError,
            DRAW + "a number above 0, at most 200 (cm) for size; it got 0",
        ),
        (
            draw,
            ("a", [], "red", "dots", 201),
            ValueError,
            DRAW + "a number above 0, at most 200 (cm) for size; it got 201",
        ),
        (plot, (1, 2), TypeError, "plot(name, value) wants a name in quotes"),
        (plot, ("a", "2"), TypeError, "plot(name, value) wants a number for value; it got '2'"),
        (plot, ("a", NAN), ValueError, "plot(name, value) wants a number for value; it got nan"),
        (
            led,
            ("rde",),
            ValueError,
            LED + "the name of a colour or '#rrggbb' for colour; it got 'rde'",
        ),
        (
            led,
            (255, 0),
            TypeError,
            LED + "a colour's name, '#rrggbb', 'off', or three numbers from 0 to 255; it got 255",
        ),
        (led, (0, 256, 0), ValueError, LED + "a number from 0 to 255 for green; it got 256"),
        (led, (0, 0, "1"), TypeError, LED + "a number from 0 to 255 for blue; it got '1'"),
        (led, ("red", 0, 0), TypeError, LED + "a number from 0 to 255 for red; it got 'red'"),
        (
            beep,
            (19,),
            ValueError,
            "beep(freq, ms) wants a number from 20 to 20000 (Hz) for freq; it got 19",
        ),
        (
            beep,
            (440, -1),
            ValueError,
            "beep(freq, ms) wants a number from 0 to 10000 (milliseconds) for ms; it got -1",
        ),
    ],
)
def test_a_wrong_argument_is_refused_by_call_wanted_and_got(
    robot: Link,
    call: Callable[..., None],
    arguments: tuple[Any, ...],
    kind: type[Exception],
    message: str,
) -> None:
    before = list(robot.trace.events)
    with pytest.raises(kind) as refusal:
        call(*arguments)
    assert isinstance(refusal.value, BugbotError)
    assert str(refusal.value).startswith(message)
    assert len(str(refusal.value)) < 220
    assert robot.trace.events == before
    assert robot.now() == 0
    assert not robot.sim.driving


@pytest.mark.parametrize(
    "number", [3, 3.0, np.float64(3), np.float32(3), np.int64(3), math.floor(3.7)]
)
def test_every_kind_of_number_is_welcome(robot: Link, number: Any) -> None:
    wait(number)
    assert robot.now() == 3


def test_half_a_character_in_a_name_is_replaced(robot: Link) -> None:
    plot("half \ud83e", 1)
    (event,) = robot.trace.of_kind("plot")
    assert event["name"].encode("utf-8")


def test_what_was_got_is_shown_short() -> None:
    assert len(got(["x" * 1000] * 1000)) < 400
    assert len(got("x" * 1000)) < 60
    assert len(got({i: [[[i]]] for i in range(1000)})) < 200


def test_where_a_thing_lies_in_memory_is_not_shown() -> None:
    assert "0x" not in got(Plain())
    assert "0x" not in got([Plain()])


def test_the_nearest_word_is_found_or_none() -> None:
    assert nearest("FOWARD", ["forward", "backward"]) == "forward"
    assert nearest("zzz", ["forward", "backward"]) is None
