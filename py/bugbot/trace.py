"""The trace: everything a run leaves behind, and the only thing anyone looks at.

May import: the standard library and `bugbot.errors`.

A trace is a header, a list of flat events in order of simulated time, and a
store of points. `KINDS` below is the one definition of the events; the page
reads the same rows and refuses a kind it does not know.

An event is a row `[kind, value, value, …]` with the values in the order that
`KINDS` gives. Units: t in seconds of simulated time, x and y in cm on the mat,
heading in degrees clockwise from up the mat, 0 to 360.

============ ==================================================================
pose         where the robot truly is; often enough to be joined by lines
scan         one look of the depth sensor: the true pose it was taken from, and
             `beams`, a flat list angle, distance, angle, distance, … (degrees
             from straight ahead, clockwise positive; cm, 200 means nothing found)
layer        a whole named layer drawn; replaces the one of that name.
             `shape` is dots, squares, line or text; `size` in cm; the points are
             `count` points from number `first` of the point store; `texts` has a
             string for each point when the shape is text, else null
plot         one point of a named line of the chart
print        text written; `stream` is stdout or stderr
note         what the program should know of a call on this line that did not do all it was told
line         the learner's line that is being carried out from this time on
led          colour of the light, 0 to 255 each
beep         a tone, `freq` in Hz for `ms` milliseconds
bump         the robot touched something at (x, y), the point of contact
fault        the program's error: Python's name of it, the message, the
             learner's line (1 first) or null, a likely cause or null, and the
             traceback with the learner's frames only
end          the last event: `status` is finished, fault, stopped or limit;
             `message` says it in words for the learner
============ ==================================================================

The point store holds x, y, x, y, … as 16-bit integers in hundredths of a cm
(`POINTS_PER_CM`), so a full redraw of a 40 by 40 map is 6.4 kB, and a layer that
is drawn again unchanged costs nothing. Points further than 327.67 cm from the
origin are stored at that distance: they are far off the mat.

As a file: JSON lines. The header first, then a row per event, then one row
`["points", text]`, the store in base64, little-endian.
"""

from __future__ import annotations

import json
import sys
from array import array
from base64 import b64decode, b64encode
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain
from math import isfinite
from typing import IO, Any

from bugbot.errors import counted

__all__ = [
    "FORMAT",
    "KINDS",
    "POINTS_PER_CM",
    "VERSION",
    "Event",
    "Trace",
    "TraceError",
    "storable",
]

FORMAT = "bugbot-trace"
VERSION = 1

KINDS: dict[str, tuple[str, ...]] = {
    "pose": ("t", "x", "y", "heading"),
    "scan": ("t", "x", "y", "heading", "beams"),
    "layer": ("t", "name", "colour", "shape", "size", "first", "count", "texts"),
    "plot": ("t", "name", "value"),
    "print": ("t", "stream", "text"),
    "note": ("t", "line", "text"),
    "line": ("t", "line"),
    "led": ("t", "red", "green", "blue"),
    "beep": ("t", "freq", "ms"),
    "bump": ("t", "x", "y"),
    "fault": ("t", "type", "message", "line", "hint", "traceback"),
    "end": ("t", "status", "message"),
}

POINTS_PER_CM = 100
"""The point store counts in hundredths of a centimetre."""

_FARTHEST = 32767

Event = tuple[Any, ...]
"""(kind, values in the order of KINDS[kind])."""


class TraceError(ValueError):
    """A trace file that is broken, or not a trace; says which line and what is wrong."""


class _Quantiser(dict[float, int]):
    """Coordinate [cm] -> stored integer, remembered.

    A map draws the same few hundred coordinates over and over, so a look-up
    that remembers is about three times as fast as rounding each one.
    """

    def __missing__(self, cm: float) -> int:
        if not isfinite(cm):  # TypeError for what is not a number: the caller explains
            raise ValueError(cm)
        stored = max(-_FARTHEST, min(_FARTHEST, round(cm * POINTS_PER_CM)))
        if len(self) < 20_000:
            self[cm] = stored
        return stored


class Trace:
    """The recorder of a run, and what is read back from a file.

    header  dict: format, version, program, world (whole), seed, kinds
    events  list of rows, oldest first
    points  array('h'): x, y, x, y, … in hundredths of a cm
    """

    def __init__(self, program: str, world: dict[str, Any], seed: int) -> None:
        self.header: dict[str, Any] = {
            "format": FORMAT,
            "version": VERSION,
            "program": program,
            "world": world,
            "seed": seed,
            "kinds": {kind: list(fields) for kind, fields in KINDS.items()},
        }
        self.events: list[Event] = []
        self.points: array[int] = array("h")
        self.bytes = 0
        """Rough size so far, for the limit; counts what has been taken as well."""
        self.bytes_of = {"scan": 0, "print": 0, "layer": 0}
        """How much of it these take."""
        self.moves: list[Any] | None = None
        """How the robot was driven, if a marking wants to drive it again: see `Simulator`."""
        self._quantise = _Quantiser()
        self._drawn: dict[str, tuple[bytes, int]] = {}
        self._taken_points = 0

    def add(self, *event: Any) -> None:
        """Append one event: its kind, then its values in the order of KINDS."""
        self.events.append(event)
        self.bytes += 64
        if event[0] == "scan":
            self._grow("scan", 64, 8 * len(event[5]))

    def write(self, t: float, stream: str, text: str) -> None:
        """Append printed text; joins the event before if that is the same stream and time."""
        length = len(text)
        self.bytes += length
        self.bytes_of["print"] += length
        if self.events:
            last = self.events[-1]
            # Joining is bounded: a million prints in one tick must not copy a growing text.
            if last[0] == "print" and last[1] == t and last[2] == stream and len(last[3]) < 1000:
                self.events[-1] = ("print", t, stream, last[3] + text)
                return
        self.bytes_of["print"] += 64
        self.add("print", t, stream, text)

    def _grow(self, kind: str, counted: int, new: int) -> None:
        self.bytes += new
        self.bytes_of[kind] += counted + new

    def layer(
        self,
        t: float,
        name: str,
        points: Sequence[Sequence[float]],
        colour: str,
        shape: str,
        size: float,
        texts: list[str] | None = None,
    ) -> None:
        """Append a layer of (x, y) points [cm].

        Each point must have exactly two numbers: `api.draw` has seen to the shape.
        Raises ValueError for NaN or infinity and TypeError for what is no number,
        before anything is recorded.
        """
        stored = array("h", map(self._quantise.__getitem__, chain.from_iterable(points)))
        drawn = stored.tobytes()
        before = self._drawn.get(name)
        if before is not None and before[0] == drawn:
            first = before[1]
        else:
            first = self._taken_points + len(self.points) // 2
            self.points.extend(stored)
            self._drawn[name] = (drawn, first)
            self._grow("layer", 0, len(drawn))
        if texts:
            self._grow("layer", 0, len("".join(texts)))
        self.bytes_of["layer"] += 64
        self.add("layer", t, name, colour, shape, size, first, len(stored) // 2, texts)

    # -- handing over --------------------------------------------------------

    def take(self) -> tuple[str, bytes]:
        """Hand over and forget what was recorded since the last `take`.

        Returns the events as JSON (a list of rows) and the new points as
        little-endian 16-bit integers. Only the bridge uses this: after it, `events`
        no longer holds the whole run.
        """
        rows = _dumps(self.events)
        points = _little_endian(self.points)
        self.events = []
        self._taken_points += len(self.points) // 2
        self.points = array("h")
        return rows, points

    # -- reading back --------------------------------------------------------

    def of_kind(self, kind: str) -> Iterator[dict[str, Any]]:
        """The events of one kind as dicts with the names of KINDS."""
        fields = KINDS[kind]
        for event in self.events:
            if event[0] == kind:
                yield dict(zip(fields, event[1:], strict=True))

    def points_of(self, layer: dict[str, Any]) -> list[tuple[float, float]]:
        """The points [cm] of a layer event as `of_kind("layer")` gives it."""
        start = 2 * layer["first"]
        flat = self.points[start : start + 2 * layer["count"]]
        return [
            (flat[i] / POINTS_PER_CM, flat[i + 1] / POINTS_PER_CM) for i in range(0, len(flat), 2)
        ]

    # -- files ---------------------------------------------------------------

    def save(self, file: IO[str]) -> None:
        """Write the trace to an open text file."""
        file.write(_dumps(self.header) + "\n")
        for event in self.events:
            file.write(_dumps(event) + "\n")
        text = b64encode(_little_endian(self.points)).decode("ascii")
        file.write(_dumps(["points", text]) + "\n")

    @classmethod
    def load(cls, lines: Iterable[str]) -> Trace:
        """Read a trace from an open text file or its lines; TraceError if it is not one."""
        numbered = enumerate(lines, 1)
        header = _header(next(numbered, (1, ""))[1])
        trace = cls(header["program"], header["world"], header["seed"])
        whole = False
        for number, line in numbered:
            if not line.strip():
                continue
            if whole:
                raise TraceError(f"line {number}: there is more after the points, the last row")
            event = _row(line, number)
            if event[0] == "points":
                trace.points = _points(event, number)
                whole = True
            else:
                trace.events.append(event)
        if not whole:
            raise TraceError("the points, the last row, are missing: the file is cut short")
        _check_layers(trace)
        return trace


def storable(text: str) -> str:
    """The text without what UTF-8 can't hold: half of a surrogate pair becomes U+FFFD."""
    if text.isascii():
        return text
    return text.encode("utf-8", "surrogatepass").decode("utf-8", "replace")


def _check_layers(trace: Trace) -> None:
    available = len(trace.points) // 2
    for layer in trace.of_kind("layer"):
        first, count = layer["first"], layer["count"]
        sound = isinstance(first, int) and isinstance(count, int) and first >= 0 and count >= 0
        if not sound or first + count > available:
            raise TraceError(
                f"the layer {layer['name']!r} at {layer['t']} s wants {count!r} points from "
                f"number {first!r}, but the file has {available}"
            )


def _dumps(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"), allow_nan=False)


def _little_endian(points: array[int]) -> bytes:
    if sys.byteorder == "big":
        points = points[:]
        points.byteswap()
    return points.tobytes()


def _json(line: str, number: int) -> Any:
    try:
        return json.loads(line)
    except ValueError as error:
        raise TraceError(f"line {number}: not JSON: {error}") from None


def _header(line: str) -> dict[str, Any]:
    header = _json(line, 1)
    if not isinstance(header, dict) or header.get("format") != FORMAT:
        raise TraceError(f'line 1: not a trace: "format" should be "{FORMAT}"')
    if header.get("version") != VERSION:
        raise TraceError(f"line 1: version {header.get('version')!r}; this reads version {VERSION}")
    wanted = {"program": str, "world": dict, "seed": int}
    for name, kind in wanted.items():
        if not isinstance(header.get(name), kind):
            raise TraceError(f'line 1: "{name}" should be of type {kind.__name__}')
    return header


def _row(line: str, number: int) -> Event:
    row = _json(line, number)
    if not isinstance(row, list) or not row or not isinstance(row[0], str):
        raise TraceError(f"line {number}: an event is a list that begins with its kind")
    fields = ("text",) if row[0] == "points" else KINDS.get(row[0])
    if fields is None:
        raise TraceError(f"line {number}: unknown kind {row[0]!r}; known: {', '.join(KINDS)}")
    if len(row) != len(fields) + 1:
        raise TraceError(
            f"line {number}: {row[0]} has {counted(len(fields), 'value')} ({', '.join(fields)}), "
            f"not {len(row) - 1}"
        )
    return tuple(row)


def _points(event: Event, number: int) -> array[int]:
    points: array[int] = array("h")
    try:
        points.frombytes(b64decode(event[1], validate=True))
    except (ValueError, TypeError) as error:
        raise TraceError(f"line {number}: the points are not base64: {error}") from None
    if len(points) % 2:
        raise TraceError(f"line {number}: the points do not come in pairs")
    if sys.byteorder == "big":
        points.byteswap()
    return points
