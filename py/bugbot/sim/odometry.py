"""Dead reckoning: where the robot believes it is, from what its feet were told to do.

May import: the standard library, `bugbot.frames`, the rest of `bugbot.sim`.

The belief starts at the true pose and then goes its own way: the gyro drifts at
a steady rate, the feet slip, and against a wall they walk on the spot, which the
robot does not notice. Turns it measures as they really come out: the gyro feels them.
"""

from __future__ import annotations

from bugbot.frames import wrap_heading
from bugbot.sim.depth import exact_direction
from bugbot.sim.noise import (
    DRIFT_MAX_DEG_S,
    DRIFT_MIN_DEG_S,
    SLIP_SCALE_SD,
    SLIP_STEP_SD,
    generator,
)
from bugbot.sim.rounding import stored

__all__ = ["Odometry"]


class Odometry:
    """The believed pose: x, y in cm from the start, heading in degrees.

    drift_deg_s  how fast the gyro drifts [degrees/s]; by default as the seed has it
    """

    def __init__(self, heading: float, seed: int, drift_deg_s: float | None = None) -> None:
        gyro = generator(seed, "gyro")
        side = 1.0 if gyro.random() < 0.5 else -1.0
        rate = DRIFT_MIN_DEG_S + (DRIFT_MAX_DEG_S - DRIFT_MIN_DEG_S) * gyro.random()
        self._feet = generator(seed, "feet")
        self._scale = self._feet.normalvariate(1.0, SLIP_SCALE_SD)
        self.drift_deg_s = side * rate if drift_deg_s is None else drift_deg_s
        self.x = 0.0
        self.y = 0.0
        self.heading = heading

    def step(self, ahead: float, aside: float, turn: float, seconds: float) -> None:
        """Believe a step: cm ahead and to the right as commanded, degrees clockwise as turned."""
        turned = turn + self.drift_deg_s * seconds
        if ahead or aside:
            sin_h, cos_h = exact_direction(self.heading + turned / 2)
            share = self._scale + self._feet.normalvariate(0.0, SLIP_STEP_SD)
            self.x = stored(self.x + share * (ahead * sin_h + aside * cos_h))
            self.y = stored(self.y + share * (ahead * cos_h - aside * sin_h))
        self.heading = wrap_heading(stored(self.heading + turned))
