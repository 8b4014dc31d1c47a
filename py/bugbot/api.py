"""The robot's calls, as a learner's program imports them.

May import: the standard library, `bugbot.errors`, `bugbot.checks`, `bugbot.link`.

The docstrings here are the help: the editor shows them on completion and hover, and
the /api/ page is made from them. Their form: one plain sentence; a line
`argument: meaning, unit, range` for each argument; "Returns …" where something is
returned; an example of two lines or so that runs (a test runs every one).

Each call checks its arguments and hands on to the link of the run that is going on.
"""

from __future__ import annotations

import sys
from typing import Any

from bugbot import checks
from bugbot.errors import WrongTypeError, WrongValueError, got
from bugbot.link import Link, active

__all__ = [
    "Robot",
    "backward",
    "battery",
    "beep",
    "clock",
    "connect",
    "distance",
    "draw",
    "drive",
    "forward",
    "go",
    "heading",
    "led",
    "left",
    "odometry",
    "plot",
    "position",
    "right",
    "scan",
    "stop",
    "turn",
    "wait",
]

_PER_CENT = "a number from -100 to 100 (per cent)"
_SPEED = "a number above 0 (per cent of full speed)"
_SLOWEST = 1e-6
"""Per cent. Slower than this is standing, where a call would wait for its end."""
_SHAPES = ("dots", "squares", "line", "text")
_DECIMALS = 6
"""Answers of the camera and the feet: the last figures of the simulator's would only puzzle."""


# -- motion --------------------------------------------------------------------


def drive(forward: float, right: float, turn: float) -> None:
    """Move in any direction and turn at the same time, until told otherwise.

    forward: speed ahead in per cent, -100 (back) to 100; 100 is 11.5 cm/s
    right: speed to the right in per cent, -100 (left) to 100; 100 is 11.5 cm/s
    turn: turning speed in per cent, -100 (left) to 100 (right); 100 is 120 degrees/s

    Numbers beyond -100 to 100 count as the nearest of the two. The robot moves while time
    passes, so follow it with wait().

    >>> drive(50, 0, 20)
    >>> wait(2)
    """
    call = "drive(forward, right, turn)"
    link = active(call)
    link.sim.drive(
        _per_cent(link, call, "forward", forward),
        _per_cent(link, call, "right", right),
        _per_cent(link, call, "turn", turn),
    )


def forward(speed: float = 50, distance: float | None = None) -> None:
    """Drive straight ahead, for ever or for a distance.

    speed: per cent of full speed, 0 to 100; 100 is 11.5 cm/s
    distance: how far in cm, 0 or more; without it the robot drives until told otherwise

    With a distance the program waits here until it is driven, and then the robot stops.
    It stops early if something is in the way.

    >>> forward(50, distance=20)
    >>> forward(100)
    """
    _straight("forward(speed, distance)", speed, distance, 1.0)


def backward(speed: float = 50, distance: float | None = None) -> None:
    """Drive straight back, for ever or for a distance.

    speed: per cent of full speed, 0 to 100; 100 is 11.5 cm/s
    distance: how far in cm, 0 or more; without it the robot drives until told otherwise

    With a distance the program waits here until it is driven, and then the robot stops.
    It stops early if something is in the way.

    >>> backward(50, distance=10)
    """
    _straight("backward(speed, distance)", speed, distance, -1.0)


def _straight(call: str, speed: Any, distance: Any, sign: float) -> None:
    link = active(call)
    per_cent = _per_cent(link, call, "speed", speed)
    if distance is None:
        link.sim.drive(sign * per_cent, 0.0, 0.0)
        return
    cm = checks.number(call, "distance", distance, "a number of 0 or more (cm)", low=0.0)
    if abs(per_cent) < _SLOWEST:
        raise WrongValueError(
            f"{call} wants a speed other than 0 when it has a distance; it got speed {got(speed)}"
        )
    link.go_straight(sign * per_cent, cm)


def _per_cent(link: Link, call: str, argument: str, value: Any, wants: str = _PER_CENT) -> float:
    """A speed, which counts as the nearest of -100 to 100; beyond that the program is told."""
    per_cent = checks.number(call, argument, value, wants)
    if abs(per_cent) > 100:
        most = "100" if per_cent > 0 else "-100"
        link.note(
            argument,
            f"{call} got {argument} {per_cent:g}, and the robot can't go faster than 100 per cent: "
            f"it counts as {most}",
        )
    return per_cent


def left(speed: float = 50) -> None:
    """Spin to the left (counter-clockwise) on the spot, until told otherwise.

    speed: per cent of full turning speed, 0 to 100; 100 is 120 degrees/s

    >>> left(30)
    >>> wait(1)
    """
    call = "left(speed)"
    link = active(call)
    link.sim.drive(0.0, 0.0, -_per_cent(link, call, "speed", speed))


def right(speed: float = 50) -> None:
    """Spin to the right (clockwise) on the spot, until told otherwise.

    speed: per cent of full turning speed, 0 to 100; 100 is 120 degrees/s

    >>> right(30)
    >>> wait(1)
    """
    call = "right(speed)"
    link = active(call)
    link.sim.drive(0.0, 0.0, _per_cent(link, call, "speed", speed))


def turn(degrees: float, speed: float = 30) -> None:
    """Turn by an angle, and wait until that is done.

    degrees: how far; positive is to the right (clockwise), negative to the left
    speed: per cent of full turning speed, above 0, to 100; 100 is 120 degrees/s

    >>> turn(90)
    >>> turn(-45, speed=50)
    """
    call = "turn(degrees, speed)"
    link = active(call)
    angle = checks.number(call, "degrees", degrees, "a number of degrees")
    per_cent = _per_cent(link, call, "speed", speed, _SPEED)
    if per_cent < _SLOWEST:
        raise WrongValueError(f"{call} wants {_SPEED} for speed; it got {got(speed)}")
    link.turn_by(angle, per_cent)


def stop() -> None:
    """Stop moving.

    >>> forward(50)
    >>> wait(1)
    >>> stop()
    """
    active("stop()").sim.drive(0.0, 0.0, 0.0)


# -- time ----------------------------------------------------------------------


def wait(seconds: float) -> None:
    """Let time pass while the robot goes on with what it is doing.

    seconds: how long, 0 or more

    >>> forward(50)
    >>> wait(0.5)
    """
    call = "wait(seconds)"
    link = active(call)
    link.advance(checks.number(call, "seconds", seconds, "a number of 0 or more", low=0.0))


def clock() -> float:
    """The time since the program started.

    Returns seconds. Computing takes no time here: only wait() and the calls that wait do.

    >>> while clock() < 3:
    ...     wait(0.1)
    """
    return active("clock()").now()


# -- sensors -------------------------------------------------------------------


def scan() -> list[tuple[float, float]]:
    """Look with the depth sensor: eight beams, 39 degrees from the first to the last.

    Returns a list of 8 pairs (angle, distance), from left to right. The angle is in degrees from
    straight ahead, positive to the right; the distance is in cm from the robot's centre, 0
    to 200. Readings are noisy by about 2 cm; 200 means that the beam found nothing.

    >>> for angle, distance_cm in scan():
    ...     print(angle, distance_cm)  # doctest: +SKIP
    """
    return active("scan()").scan()


def distance() -> float:
    """Look straight ahead with the depth sensor.

    Returns the distance in cm from the robot's centre, 0 to 200, noisy by about 2 cm; 200 means
    that nothing was found.

    >>> if distance() < 20:
    ...     stop()
    """
    return active("distance()").distance()


def position() -> tuple[float, float]:
    """Where the robot is, seen from where it started.

    Returns (x, y) in cm: x to the right on the mat, y up the mat, (0, 0) at the start. It comes
    from a camera above the mat and is exact; on a mat without a camera it is an error.

    >>> x, y = position()
    """
    sim = active("position()").seen_from_above("position()")
    return round(sim.x - sim.start_x, _DECIMALS), round(sim.y - sim.start_y, _DECIMALS)


def heading() -> float:
    """Which way the robot faces.

    Returns degrees from 0 to 360, clockwise from straight up the mat: 90 is to the right. It
    comes from a camera above the mat and is exact; on a mat without a camera it is an error.

    >>> facing = heading()
    """
    sim = active("heading()").seen_from_above("heading()")
    return round(sim.heading, _DECIMALS) % 360.0


def odometry() -> tuple[float, float, float]:
    """Where the robot itself believes it is, from its gyro and its own steps.

    Returns (x, y, heading): cm from where it started, and degrees clockwise from up the mat. The
    gyro drifts by about 0.2 degrees/s and the feet slip a little, so the longer the run, the
    further this is from position() and heading().

    >>> x, y, facing = odometry()
    """
    belief = active("odometry()").sim.odometry
    return (
        round(belief.x, _DECIMALS),
        round(belief.y, _DECIMALS),
        round(belief.heading, _DECIMALS) % 360.0,
    )


def battery() -> float:
    """What is left in the battery.

    Returns per cent, 100 at the start of a program.

    >>> if battery() < 10:
    ...     stop()
    """
    return active("battery()").sim.battery()


# -- output --------------------------------------------------------------------


def draw(
    name: str, points: Any, colour: str = "black", shape: str = "dots", size: float = 2
) -> None:
    """Draw a layer on the view from above, in place of the layer of that name.

    name: what to call the layer, as the legend shows it
    points: a list of points (x, y) in cm on the mat; an empty list clears the layer
    colour: a name like "red" or "#rrggbb"
    shape: "dots", "squares" (with the points as their centres), "line" or "text"
    size: side of a square, width of a dot or line, height of text, in cm, above 0 to 200

    For text a point may be (x, y, "words"); without words it shows the layer's name.

    >>> draw("wall", [(102.5, 152.5), (107.5, 152.5)], "black", "squares", 5)
    >>> draw("goal", [(100, 150)], colour="red", size=4)
    """
    call = "draw(name, points, colour, shape, size)"
    link = active(call)
    layer = checks.name(call, name)
    form = checks.choice(call, "shape", shape, _SHAPES)
    places, texts = checks.points(call, points, layer, form)
    ink = checks.colour(call, colour)
    wants = "a number above 0, at most 200 (cm)"
    cm = checks.number(call, "size", size, wants, low=0.01, high=200.0)
    link.draw(layer, places, ink, form, cm, texts)


def plot(name: str, value: float) -> None:
    """Add a point to a line of the chart, at the present time.

    name: which line, as the legend shows it
    value: a number

    >>> plot("battery %", battery())
    """
    call = "plot(name, value)"
    link = active(call)
    line = checks.name(call, name)
    link.record("plot", line, checks.number(call, "value", value, "a number"))


def led(colour: Any = "off", green: float | None = None, blue: float | None = None) -> None:
    """Set the colour of the robot's light.

    colour: a name like "red", "#rrggbb" or "off"; or the amount of red, 0 to 255
    green: the amount of green, 0 to 255, if the first is the amount of red
    blue: the amount of blue, 0 to 255, if the first is the amount of red

    >>> led("orange")
    >>> led(255, 160, 0)
    """
    call = "led(colour) or led(red, green, blue)"
    link = active(call)
    if green is None and blue is None and isinstance(colour, str):
        word = colour.strip().lower()
        parts = (0, 0, 0) if word == "off" else checks.rgb(checks.colour(call, colour))
    else:
        if green is None or blue is None:
            raise WrongTypeError(
                f"{call} wants a colour's name, '#rrggbb', 'off', or three numbers from 0 to 255; "
                f"it got {got(colour)}"
            )
        wants = "a number from 0 to 255"
        amounts = zip(("red", "green", "blue"), (colour, green, blue), strict=True)
        red, green, blue = (
            round(checks.number(call, part, amount, wants, 0, 255)) for part, amount in amounts
        )
        parts = (red, green, blue)
    link.record("led", *parts)


def beep(freq: float, ms: float = 200) -> None:
    """Sound a tone while the program goes on.

    freq: pitch in Hz, 20 to 20000; 440 is the A above middle C
    ms: how long in milliseconds, 0 to 10000

    >>> beep(440)
    >>> beep(880, ms=100)
    """
    call = "beep(freq, ms)"
    link = active(call)
    hertz = checks.number(call, "freq", freq, "a number from 20 to 20000 (Hz)", 20, 20_000)
    wants = "a number from 0 to 10000 (milliseconds)"
    link.record("beep", hertz, checks.number(call, "ms", ms, wants, 0, 10_000))


# -- connection ----------------------------------------------------------------


class Robot:
    """The robot as an object: every call of this package as a method.

    Use it in a `with` block to have the robot stopped at the end of the block.

    >>> with Robot() as robot:
    ...     robot.forward(50, distance=10)
    """

    def __init__(self, *address: object, **options: object) -> None:
        # The real robot takes an address; a simulated one needs none, and a program that
        # gives it must run unchanged.
        active("Robot()")

    def __enter__(self) -> Robot:
        return self

    def __exit__(self, *error: object) -> None:
        stop()

    def __repr__(self) -> str:
        return "<the robot>"

    backward = staticmethod(backward)
    battery = staticmethod(battery)
    beep = staticmethod(beep)
    clock = staticmethod(clock)
    distance = staticmethod(distance)
    draw = staticmethod(draw)
    drive = staticmethod(drive)
    forward = staticmethod(forward)
    heading = staticmethod(heading)
    led = staticmethod(led)
    left = staticmethod(left)
    odometry = staticmethod(odometry)
    plot = staticmethod(plot)
    position = staticmethod(position)
    right = staticmethod(right)
    scan = staticmethod(scan)
    stop = staticmethod(stop)
    turn = staticmethod(turn)
    wait = staticmethod(wait)


def connect(*address: object, **options: object) -> Robot:
    """Connect to the robot.

    address: which robot, as the real one needs it; here it may be left out

    Returns the robot: its methods are the calls of this package.

    >>> robot = connect()
    >>> robot.forward(50, distance=10)
    """
    active("connect()")
    return Robot(*address, **options)


def go() -> None:
    """Put every name of bugbot into the program, as `from bugbot import *` does.

    >>> import bugbot
    >>> bugbot.go()
    """
    active("go()")
    here = globals()
    sys._getframe(1).f_globals.update({each: here[each] for each in __all__ if each != "go"})
