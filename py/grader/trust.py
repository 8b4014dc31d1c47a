"""A trace held against the truth: is it what the robot did and saw?

May import: the standard library, `bugbot.frames`, `bugbot.sim`, `bugbot.trace`, `bugbot.worlds`.

A program that gets behind the robot's calls can put the robot anywhere, take the noise
off its sensor, wipe out that it ran into something, or write a trace of its own. None of that goes
unseen: the run is made once more, here, from nothing but the moves that were asked for. The
simulator gives the same run from the same world, seed and moves, so each pose, each reading and
each bump has to be there, in this order and at these times; all that the program drew or wrote
must have come at a moment when it could, and the run ends when its moves do.

So whoever makes up a run has to make up one that the robot can make, and that is a run.
"""

from __future__ import annotations

from math import hypot
from typing import Any

from bugbot.frames import turn_between
from bugbot.sim.simulator import Simulator
from bugbot.trace import Event, Trace
from bugbot.worlds import World

__all__ = ["doubt"]

Doubt = tuple[str, float]

_SLACK = 1e-6
"""Poses and times are kept to 1e-9, and engines agree on them [cm, degrees, s]."""

_READING_SLACK_CM = 0.11
"""Readings are whole millimetres; engines may round a tie either way."""

_SIMULATED = ("pose", "scan", "bump")


def doubt(trace: Trace, world: World) -> Doubt | None:
    """Why this can't be what the robot did, and when [s]; None if all is well."""
    if trace.moves is None:
        return "there is no record of how the robot was driven", 0.0
    end = trace.events[-1][1] if trace.events else 0.0
    again = Trace("", world.to_dict(), trace.header["seed"])
    claimed = [event for event in trace.events if event[0] in _SIMULATED]
    sim = Simulator(world, trace.header["seed"], again)
    moments = _drive(sim, again, trace.moves, end, len(claimed))
    return _about_record(claimed, again.events) or _about_moments(trace, moments)


def _drive(sim: Simulator, made: Trace, moves: list[Any], end: float, claimed: int) -> set[float]:
    """Make the moves, as far as the run goes; the moments between them.

    Looks take no time, so what has been made is counted as well: once it is more than the record
    claims, the two differ and the rest would only keep the judge.
    """
    moments = {sim.t}
    for move in moves:
        if sim.t > end + _SLACK or len(made.events) > claimed:
            break
        if move == 1:
            sim.distance()
        elif isinstance(move, int):
            sim.scan()
        else:
            forward, right, turn, seconds, until_blocked = move
            sim.drive(forward, right, turn)
            sim.advance(seconds, until_blocked)
            moments.add(sim.t)
    sim.finish()
    return moments


def _about_record(claimed: list[Event], true: list[Event]) -> Doubt | None:
    """What parts the record from the run that its moves make."""
    for event, real in zip(claimed, true, strict=False):
        found = _parts(event, real)
        if found is not None:
            return found, event[1]
    if len(claimed) == len(true):
        return None
    more = (claimed if len(claimed) > len(true) else true)[min(len(claimed), len(true))]
    return _missing(more), more[1]


def _parts(event: Event, real: Event) -> str | None:
    if event[0] != real[0]:
        return _missing(event if "bump" not in (event[0], real[0]) else ("bump",))
    if abs(event[1] - real[1]) > _SLACK:
        return "the robot is somewhere it can't have driven or turned to in the time"
    if hypot(event[2] - real[2], event[3] - real[3]) > _SLACK:
        if event[0] == "bump":
            return _missing(event)
        return "the robot is somewhere it can't have driven or turned to in the time"
    if event[0] == "bump":
        return None
    if abs(turn_between(event[4], real[4])) > _SLACK:
        return "the robot is somewhere it can't have driven or turned to in the time"
    if event[0] == "scan":
        return _about_beams(event[5], real[5])
    return None


def _about_beams(read: list[float], real: list[float]) -> str | None:
    if read[::2] != real[::2]:
        return "its sensor has looked where it has no beams"
    for reading, true in zip(read[1::2], real[1::2], strict=True):
        if abs(reading - true) > _READING_SLACK_CM:
            return "its sensor has read what it can't read there"
    return None


def _missing(event: Event) -> str:
    return {
        "pose": "the record of its movement has a gap",
        "scan": "the record of its looks is not that of the sensor",
        "bump": "the record of what it ran into has been changed",
    }[event[0]]


def _about_moments(trace: Trace, moments: set[float]) -> Doubt | None:
    """Something told at a time when no program can have told it, or an end before the end."""
    for event in trace.events:
        if event[0] not in _SIMULATED and event[1] not in moments:
            return f"the record has an event ({event[0]}) from when no program was asked", event[1]
    if trace.events and abs(trace.events[-1][1] - max(moments)) > _SLACK:
        return "the run ends before its last move does, or after it", trace.events[-1][1]
    return None
