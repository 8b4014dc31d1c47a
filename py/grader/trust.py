"""A trace held against the truth: could the robot have done and seen this?

May import: the standard library, `bugbot.frames`, `bugbot.sim`, `bugbot.trace`,
`bugbot.worlds`, `grader.failures`.

A program that gets behind the robot's calls can put the robot anywhere, take the noise
off its sensor, or write a trace of its own. None of that goes unseen:

* The robot starts where the world says, is never nearer to anything than its radius, and moves
  and turns no faster than it can in that world. A moving robot is recorded every 0.04 s, so it
  can't jump through a wall between two records.
* Each reading is the one that the simulator gives at that place with this seed. The noise comes
  from one generator, so the readings can simply be made once more.
"""

from __future__ import annotations

from math import hypot

from bugbot.frames import MAT_CM, ROBOT_RADIUS_CM, turn_between
from bugbot.sim.depth import AHEAD, BEAMS, distances, read
from bugbot.sim.motion import SPEED_CM_S, SPIN_DEG_S
from bugbot.sim.noise import generator
from bugbot.sim.world import boxes_of
from bugbot.trace import Trace
from bugbot.worlds import World

__all__ = ["doubt"]

_FASTEST_CM_S = SPEED_CM_S * 2**0.5
"""Ahead and sideways at once."""

_RECORDED_EVERY_S = 0.04
_SLACK = 1e-4
"""Poses are kept to 1e-9, and the first touch of a wall is as near as 1e-7 [cm, degrees]."""

_READING_SLACK_CM = 0.11
"""Readings are whole millimetres; engines may round a tie either way."""


def doubt(trace: Trace, world: World) -> tuple[str, float] | None:
    """Why this can't be what the robot did, and when [s]; None if all is well."""
    return _about_motion(trace, world) or _about_readings(trace, world)


def _about_motion(trace: Trace, world: World) -> tuple[str, float] | None:
    start = world.start
    t, x, y, heading = 0.0, start.x, start.y, start.heading
    fastest_cm_s = _FASTEST_CM_S * (1.0 - world.odometry.slip)
    spin_deg_s = SPIN_DEG_S * world.odometry.turn_scale
    for event in trace.events:
        if event[0] not in ("pose", "scan"):
            continue
        now, next_x, next_y, next_heading = event[1:5]
        if (next_x, next_y, next_heading) != (x, y, heading):
            passed = now - t
            moved = hypot(next_x - x, next_y - y)
            turned = abs(turn_between(heading, next_heading))
            if moved > fastest_cm_s * passed + _SLACK or turned > spin_deg_s * passed + _SLACK:
                return "the robot is somewhere it can't have driven or turned to in the time", now
            if passed > _RECORDED_EVERY_S + _SLACK:
                return "the record of its movement has a gap", now
            if not _is_clear(world, next_x, next_y):
                return "the robot is inside something solid", now
        t, x, y, heading = now, next_x, next_y, next_heading
    return None


def _is_clear(world: World, x: float, y: float) -> bool:
    low, high = ROBOT_RADIUS_CM - _SLACK, MAT_CM - ROBOT_RADIUS_CM + _SLACK
    if not (low <= x <= high and low <= y <= high):
        return False
    return all(each.gap(x, y) >= low for each in world.obstacles)


def _about_readings(trace: Trace, world: World) -> tuple[str, float] | None:
    boxes = boxes_of(world)
    chance = generator(trace.header["seed"], "depth")
    for event in trace.events:
        if event[0] != "scan":
            continue
        t, x, y, heading, flat = event[1:]
        beams = AHEAD if len(flat) == 2 else BEAMS
        angles = [beam[0] for beam in beams]
        if flat[::2] != angles:
            return "its sensor has looked where it has no beams", t
        true = distances(boxes, x, y, heading, beams)
        for cm, reading in zip(true, flat[1::2], strict=True):
            if abs(read(cm, chance) - reading) > _READING_SLACK_CM:
                return "its sensor has read what it can't read there", t
    return None
