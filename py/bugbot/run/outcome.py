"""The summary of a finished run, computed from its trace and nothing else.

May import: the standard library, `bugbot.trace`.
"""

from __future__ import annotations

from typing import Any

from bugbot.trace import Trace, TraceError

__all__ = ["outcome_of"]


def outcome_of(trace: Trace) -> dict[str, Any]:
    """What a run came to, ready for JSON.

    status   finished, fault, stopped or limit; `message` says it in words
    seconds  of simulated time
    console  all that was printed, both streams in order
    notes    what calls did not do as they were told: line and text of each
    pose     where the robot ended: x, y [cm], heading [degrees]
    series   line of the chart -> [[t, value], …]
    layers   name -> its last drawing: shape, size, colour, points [[x, y], …] in cm, and texts
             if it is text; a cleared layer has no points
    fault    null, or type, message, line and hint of the error

    Raises TraceError for a trace without an end: the run was not finished.
    """
    end = next(trace.of_kind("end"), None)
    if end is None:
        raise TraceError("the run has no end event: it was cut short")
    pose = {"x": 0.0, "y": 0.0, "heading": 0.0}
    for event in trace.of_kind("pose"):
        pose = {key: event[key] for key in pose}
    series: dict[str, list[list[float]]] = {}
    for event in trace.of_kind("plot"):
        series.setdefault(event["name"], []).append([event["t"], event["value"]])
    fault = next(trace.of_kind("fault"), None)
    return {
        "status": end["status"],
        "message": end["message"],
        "seconds": end["t"],
        "console": "".join(event["text"] for event in trace.of_kind("print")),
        "notes": [{key: note[key] for key in ("line", "text")} for note in trace.of_kind("note")],
        "pose": pose,
        "series": series,
        "layers": _layers(trace),
        "fault": fault and {key: fault[key] for key in ("type", "message", "line", "hint")},
    }


def _layers(trace: Trace) -> dict[str, dict[str, Any]]:
    last = {event["name"]: event for event in trace.of_kind("layer")}
    layers = {}
    for name, event in last.items():
        layer = {key: event[key] for key in ("shape", "size", "colour")}
        layer["points"] = [list(point) for point in trace.points_of(event)]
        if event["texts"] is not None:
            layer["texts"] = event["texts"]
        layers[name] = layer
    return layers
