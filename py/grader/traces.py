"""A trace that comes from elsewhere, checked row by row before anyone looks into it.

May import: the standard library, `bugbot.trace`, `performer.values`.

The performer's interpreter belonged to the learner's program, which may have written whatever it
liked in place of the trace. What is checked here is the form only: that every row is one of
`bugbot.trace.KINDS`, with values of the right type, in order of time, within the time limit.
Whether it can be true is `grader.trust`'s question.
"""

from __future__ import annotations

import json
import sys
from array import array
from base64 import b64decode
from typing import Any

from bugbot.trace import KINDS, Event, Trace
from performer.values import MalformedError

__all__ = ["trace_from"]

_TEXTS = {"name", "colour", "shape", "stream", "text", "type", "message", "traceback", "status"}
_WHOLE = {"first", "count", "red", "green", "blue"}
_MOST_EVENTS = 2_000_000
_LARGEST = 1e300
_LOOKS = (1, 8)
"""Beams of a look."""


def trace_from(data: Any, world: dict[str, Any], seed: int, longest_s: float) -> Trace:
    """The trace of {"events": JSON text of the rows, "points": base64, "moves"}.

    Raises MalformedError if it is none.
    """
    try:
        rows = json.loads(data["events"])
        points = array("h")
        points.frombytes(b64decode(data["points"], validate=True))
    except (TypeError, ValueError, KeyError, RecursionError) as error:
        raise MalformedError(f"the trace can't be read: {error}") from None
    if sys.byteorder == "big":
        points.byteswap()
    if not isinstance(rows, list) or len(rows) > _MOST_EVENTS:
        raise MalformedError("the trace has no list of events")
    trace = Trace("", world, seed)
    trace.points = points
    trace.moves = _moves(data.get("moves"), longest_s)
    before = 0.0
    for row in rows:
        event = _event(row, len(points) // 2)
        if not before <= event[1] <= longest_s + 1e-6:
            raise MalformedError(f"an event of the kind {event[0]} is out of time")
        before = event[1]
        trace.events.append(event)
    if [event[0] for event in trace.events].count("end") != 1 or trace.events[-1][0] != "end":
        raise MalformedError("the trace does not end with an end, its only one")
    return trace


def _moves(rows: Any, longest_s: float) -> list[Any]:
    """How the robot was driven: stretches of time, none longer than a run may be, and looks."""
    if not isinstance(rows, list) or len(rows) > _MOST_EVENTS:
        raise MalformedError("the trace does not say how the robot was driven")
    for row in rows:
        if type(row) is int and row in _LOOKS:
            continue
        if not (isinstance(row, list) and len(row) == 5 and all(map(_is_number, row[:4]))):
            raise MalformedError("one of its moves is no move")
        if type(row[4]) is not bool or not 0 <= row[3] <= longest_s:
            raise MalformedError("one of its moves is no move")
    return rows


def _event(row: Any, points: int) -> Event:
    named = isinstance(row, list) and bool(row) and isinstance(row[0], str)
    fields = KINDS.get(row[0]) if named else None
    if fields is None or len(row) != len(fields) + 1:
        raise MalformedError("an event is of no known kind")
    for field, value in zip(fields, row[1:], strict=True):
        if not _sound(row[0], field, value):
            raise MalformedError(f"an event of the kind {row[0]} has a wrong {field}")
    if row[0] == "layer" and row[6] + row[7] > points:
        raise MalformedError("a layer has more points than there are")
    return tuple(row)


def _sound(kind: str, field: str, value: Any) -> bool:
    if field in _TEXTS:
        return isinstance(value, str)
    if field in _WHOLE:
        return type(value) is int and value >= 0
    if field == "line":
        return type(value) is int or (kind == "fault" and value is None)
    if field == "hint":
        return value is None or isinstance(value, str)
    if field == "texts":
        return value is None or (isinstance(value, list) and all(isinstance(e, str) for e in value))
    if field == "beams":
        return isinstance(value, list) and len(value) % 2 == 0 and all(map(_is_number, value))
    return _is_number(value)


def _is_number(value: Any) -> bool:
    return type(value) in (int, float) and -_LARGEST < value < _LARGEST
