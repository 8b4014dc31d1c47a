"""One robot in one world: commands and questions in, true answers and events out.

May import: the standard library, `bugbot.frames`, `bugbot.trace`, `bugbot.worlds`, the rest of
`bugbot.sim`.

Time moves only in `advance`, in steps of 0.02 s (the last one shorter). The state
is rounded as it is stored, so that all engines agree on every run (see `rounding.py`).

So a run can be made once more from its moves alone. They are kept in the trace's `moves`, if it
has a list there: `[forward, right, turn, seconds, until blocked]` for each stretch of time, in per
cents, and between them the number of beams of each look.
"""

from __future__ import annotations

from math import ceil

from bugbot.frames import wrap_heading
from bugbot.sim import depth
from bugbot.sim.depth import exact_direction
from bugbot.sim.motion import first_touch, speeds
from bugbot.sim.noise import generator
from bugbot.sim.odometry import Odometry
from bugbot.sim.rounding import stored
from bugbot.sim.world import boxes_of
from bugbot.trace import Trace
from bugbot.worlds import World

__all__ = ["STEP_S", "Simulator"]

STEP_S = 0.02
"""The simulation's step [s]."""

_POSE_EVERY_STEPS = 2
"""A moving robot's pose is recorded every so many steps, 0.04 s: smooth when joined by lines."""

_TOUCHING_CM = 1e-6

_BATTERY_S = 7200.0
"""How long a full battery lasts [s]."""


class Simulator:
    """The robot's true state, and the trace it leaves.

    t        seconds since the program started
    x, y     the centre, on the mat [cm]
    heading  degrees clockwise from up the mat, 0 to 360
    camera   whether a camera tells the program its true pose
    """

    def __init__(self, world: World, seed: int, trace: Trace) -> None:
        self.t = 0.0
        self.x = self.start_x = stored(world.start.x)
        self.y = self.start_y = stored(world.start.y)
        self.heading = wrap_heading(stored(world.start.heading))
        self.camera = world.camera
        self.odometry = Odometry(self.heading, seed, world.odometry.drift_deg_s)
        self.ever_driven = False
        self._turn_scale = world.odometry.turn_scale
        self._grip = 1.0 - world.odometry.slip
        self._boxes = boxes_of(world)
        self._trace = trace
        self._chance = generator(seed, "depth")
        self._command = (0.0, 0.0, 0.0)
        self._speeds = (0.0, 0.0, 0.0)
        self._bumped = False
        self._touched = (0.0, 0.0)
        self._obstacles = world.obstacles
        self._place = (self.x, self.y, self.heading)
        self._recorded_t = self._still_until = 0.0
        trace.add("pose", 0.0, *self._place)

    # -- commands ------------------------------------------------------------

    @property
    def driving(self) -> bool:
        """Whether the last command was to move."""
        return any(self._speeds)

    def drive(self, forward: float, right: float, turn: float) -> None:
        """Move like this from now on: per cents, clamped to -100 to 100."""
        self._command = (forward, right, turn)
        self._speeds = speeds(forward, right, turn)
        self.ever_driven = self.ever_driven or self.driving

    def advance(self, seconds: float, until_blocked: bool = False) -> bool:
        """Let time pass; with `until_blocked` only until something stops the robot.

        Returns whether it ended early, because the robot was stopped.
        """
        if self._trace.moves is not None:
            self._trace.moves.append([*self._command, seconds, until_blocked])
        begin = self.t
        end = stored(begin + seconds)
        if not self.driving:
            self.odometry.step(0.0, 0.0, 0.0, end - begin)
            self.t = end
            return False
        ahead, aside, spin = self._speeds
        self._record_pose()
        heading = begin_heading = self.heading
        steps = ceil((end - begin) / STEP_S - 1e-6)
        before = begin
        stopped = False
        for step in range(1, steps + 1):
            now = end if step == steps else stored(begin + step * STEP_S)
            length = now - before
            # From the start of this stretch, so that rounding does not add up: turn(90) is exact.
            next_heading = stored(begin_heading + self._turn_scale * spin * (now - begin))
            blocked = False
            if ahead or aside:
                sin_h, cos_h = exact_direction((heading + next_heading) / 2)
                walked = self._grip * length
                dx = (ahead * sin_h + aside * cos_h) * walked
                dy = (ahead * cos_h - aside * sin_h) * walked
                blocked = self._move(dx, dy, now)
            self.odometry.step(ahead * length, aside * length, next_heading - heading, length)
            heading = next_heading
            self.heading = wrap_heading(heading)
            self.t = before = now
            if step % _POSE_EVERY_STEPS == 0:
                self._record_pose()
            stopped = blocked and until_blocked
            if stopped:
                break
        self._record_pose()
        return stopped

    def _move(self, dx: float, dy: float, now: float) -> bool:
        """Move by (dx, dy) or as far as it goes; whether something was in the way."""
        touch = first_touch(self._boxes, self.x, self.y, dx, dy)
        share = 1.0 if touch is None else touch[0]
        before = (self.x, self.y)
        self.x = stored(self.x + share * dx)
        self.y = stored(self.y + share * dy)
        if (self.x, self.y) != before:
            self._bumped = False
        if touch is None:
            return False
        self._touched = touch[1:]
        if not self._bumped:
            self._bumped = True
            self._record_standing()  # it ended before this moment
            self._trace.add("bump", now, stored(touch[1]), stored(touch[2]))
        return True

    # -- questions -----------------------------------------------------------

    def scan(self) -> list[tuple[float, float]]:
        """The eight readings: (angle from straight ahead [degrees], distance [cm])."""
        return self._look(depth.BEAMS)

    def distance(self) -> float:
        """The reading straight ahead [cm]."""
        return self._look(depth.AHEAD)[0][1]

    def touched(self) -> str:
        """What stopped the robot last, and where, in words."""
        x, y = self._touched
        where = f"at ({x:.1f}, {y:.1f})"
        names = (f"the {each.name}" for each in self._obstacles if each.gap(x, y) < _TOUCHING_CM)
        return f"{next(names, 'the wall round the mat')} {where}"

    def battery(self) -> float:
        """What is left in the battery [per cent]."""
        return round(max(0.0, 100.0 * (1.0 - self.t / _BATTERY_S)), 1)

    def _look(self, beams: tuple[depth.Beam, ...]) -> list[tuple[float, float]]:
        if self._trace.moves is not None:
            self._trace.moves.append(len(beams))
        true = depth.distances(self._boxes, self.x, self.y, self.heading, beams)
        readings = [
            (beam[0], depth.read(cm, self._chance)) for beam, cm in zip(beams, true, strict=True)
        ]
        flat = [value for reading in readings for value in reading]
        self._trace.add("scan", self.t, self.x, self.y, self.heading, flat)
        return readings

    # -- events --------------------------------------------------------------

    def finish(self) -> None:
        """Record the last pose; nothing moves after this."""
        self._record_pose()
        self._record_standing()

    def _record_pose(self) -> None:
        """Record where the robot is now.

        While it stays in one place only the first and the last moment are recorded,
        so that a player that joins poses by lines shows it standing in between.
        """
        place = (self.x, self.y, self.heading)
        if place == self._place:
            self._still_until = self.t
            return
        self._record_standing()
        self._place = place
        self._recorded_t = self._still_until = self.t
        self._trace.add("pose", self.t, *place)

    def _record_standing(self) -> None:
        """Record the last moment the robot stood where it stands, if it has not been."""
        if self._still_until > self._recorded_t:
            self._recorded_t = self._still_until
            self._trace.add("pose", self._still_until, *self._place)
