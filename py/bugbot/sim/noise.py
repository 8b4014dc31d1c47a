"""Where chance comes from, and how strong each noise is.

May import: the standard library only.

One generator per source, each seeded by the run's seed and the source's name, so
a program that scans more often does not change how its feet slip. Only `random()`
and `normalvariate()` are used: they give the same bits on every engine, which
`gauss()` does not.
"""

from __future__ import annotations

from random import Random

__all__ = [
    "DEPTH_SD_CM",
    "DRIFT_MAX_DEG_S",
    "DRIFT_MIN_DEG_S",
    "SLIP_SCALE_SD",
    "SLIP_STEP_SD",
    "generator",
]

DEPTH_SD_CM = 2.0
"""Standard deviation of a depth reading that found something [cm]."""

DRIFT_MIN_DEG_S = 0.15
DRIFT_MAX_DEG_S = 0.25
"""A run's gyro drifts at a steady rate between these, to one side or the other [degrees/s]."""

SLIP_SCALE_SD = 0.02
"""Spread, from run to run, of the share by which dead reckoning misjudges distance."""

SLIP_STEP_SD = 0.1
"""Spread, from one step of the simulation to the next, of that share."""


def generator(seed: int, source: str) -> Random:
    """The generator of one noise source ("depth", "gyro", "feet") in the run with this seed."""
    return Random(f"{seed}:{source}")
