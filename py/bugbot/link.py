"""What the robot's calls act on: the one run that is going on.

May import: the standard library, `bugbot.errors`, `bugbot.trace`, `bugbot.worlds`,
`bugbot.sim`.

`bugbot.api` asks `active()` for the link and calls its methods; `bugbot.run`
makes a link for each run. Every method goes through `check` first, which is where
a run that has used up a limit is ended, and where a page gets to take what has
been recorded so far.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from math import copysign, hypot, tau
from typing import Any, Protocol

from bugbot.errors import NoCameraError, NoRobotError
from bugbot.sim.motion import speeds
from bugbot.sim.simulator import Simulator
from bugbot.trace import Trace
from bugbot.worlds import World

__all__ = ["Guard", "Link", "active", "connected"]


_SHORT_CM = 0.05
"""A distance that is short by less than this has been driven [cm]."""

_MOST_NOTES = 20
"""Of one run."""


class Guard(Protocol):
    """What watches over a run: `bugbot.run.limits` has the one that ends it."""

    def check(self) -> None:
        """Called in each of the robot's calls; raises when the run must end."""

    def looked(self) -> None:
        """Called before the depth sensor is used; raises when the run must end."""

    def time_passed(self, now: float) -> None:
        """Called when simulated time has passed, with the new time [s]."""

    def allow(self, now: float, seconds: float) -> float:
        """How many of these seconds may still pass [s]."""

    def time_is_up(self) -> None:
        """Called when fewer seconds passed than were asked for; raises."""


class Link:
    """One run: its simulator, its trace, and the learner's file it belongs to."""

    def __init__(self, world: World, seed: int, trace: Trace, filename: str, guard: Guard) -> None:
        self.sim = Simulator(world, seed, trace)
        self.trace = trace
        self.filename = filename
        self.small_turns: list[tuple[int | None, float]] = []
        """Line and degrees of turns small enough to be radians by mistake."""
        self._noted: set[tuple[int, str]] = set()
        self._guard = guard
        self._line: int | None = None

    def now(self) -> float:
        """Seconds since the program started."""
        return self.sim.t

    def seen_from_above(self, call: str) -> Simulator:
        """The simulator, asked for its true pose; NoCameraError if nothing watches the mat."""
        if not self.sim.camera:
            raise NoCameraError(
                f"{call} needs a camera above the mat, and this mat has none; "
                "odometry() is all that the robot has"
            )
        return self.sim

    def check(self) -> None:
        """End the run here if it must end."""
        self._guard.check()

    def advance(self, seconds: float, until_blocked: bool = False, line: int | None = None) -> bool:
        """Let simulated time pass, with the learner's line recorded first; whether it was blocked.

        line  where the program waits, if that is not the line being carried out
        """
        line = line or self.learner_line()
        before = self.sim.t
        if line is not None and line != self._line:
            self._line = line
            self.trace.add("line", self.sim.t, line)
        allowed = self._guard.allow(self.sim.t, seconds)
        blocked = self.sim.advance(min(seconds, allowed), until_blocked)
        if self.sim.t != before:
            self._guard.time_passed(self.sim.t)
        if allowed < seconds and not blocked:
            self._guard.time_is_up()
        self._guard.check()
        return blocked

    def scan(self) -> list[tuple[float, float]]:
        """The eight readings: (angle from straight ahead [degrees], distance [cm])."""
        self._guard.looked()
        return self.sim.scan()

    def distance(self) -> float:
        """The reading straight ahead [cm]."""
        self._guard.looked()
        return self.sim.distance()

    def go_straight(self, per_cent: float, cm: float) -> None:
        """Drive ahead, or back if negative, until this far or blocked; then stop."""
        self.sim.drive(per_cent, 0.0, 0.0)
        speed = abs(speeds(per_cent, 0.0, 0.0)[0])
        x, y = self.sim.x, self.sim.y
        blocked = self.advance(cm / speed, until_blocked=True)
        self.sim.drive(0.0, 0.0, 0.0)
        driven = hypot(self.sim.x - x, self.sim.y - y)
        if blocked and cm - driven > _SHORT_CM:
            self.note(
                "stopped short",
                f"the robot drove {driven:.1f} cm and not {cm:g}: it touched {self.sim.touched()}",
            )

    def turn_by(self, degrees: float, per_cent: float) -> None:
        """Turn on the spot by these degrees, clockwise positive; then stop."""
        if 0 < abs(degrees) < 2 * tau and len(self.small_turns) < 100:
            self.small_turns.append((self.learner_line(), degrees))
        self.sim.drive(0.0, 0.0, copysign(per_cent, degrees))
        spin = abs(speeds(0.0, 0.0, per_cent)[2])
        self.advance(abs(degrees) / spin)
        self.sim.drive(0.0, 0.0, 0.0)

    def note(self, about: str, text: str) -> None:
        """Tell, once a line, of a call that did not do all that it was told."""
        line = self.learner_line()
        if line is not None and (line, about) not in self._noted and len(self._noted) < _MOST_NOTES:
            self._noted.add((line, about))
            self.trace.add("note", self.sim.t, line, text)

    def record(self, kind: str, *values: Any) -> None:
        """Record an event of the present time."""
        self.trace.add(kind, self.sim.t, *values)

    def draw(
        self,
        name: str,
        points: Sequence[Sequence[float]],
        colour: str,
        shape: str,
        size: float,
        texts: list[str] | None,
    ) -> None:
        """Record a whole layer."""
        self.trace.layer(self.sim.t, name, points, colour, shape, size, texts)

    def learner_line(self) -> int | None:
        """The line of the learner's file that is being carried out, or None outside it."""
        frame = sys._getframe(1)
        while frame.f_code.co_filename != self.filename:
            if frame.f_back is None:
                return None
            frame = frame.f_back
        return frame.f_lineno


_active: Link | None = None


def active(call: str) -> Link:
    """The link of the run going on; NoRobotError, naming the call, if there is none."""
    if _active is None:
        raise NoRobotError(
            f"{call} has no robot to talk to: press Run in the lab, or type "
            "python -m bugbot run and the name of your program's file"
        )
    _active.check()
    return _active


@contextmanager
def connected(link: Link) -> Iterator[Link]:
    """Inside this block the robot's calls act on `link`."""
    global _active
    before, _active = _active, link
    try:
        yield link
    finally:
        _active = before
