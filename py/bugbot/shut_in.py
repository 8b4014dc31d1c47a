"""One run in the sandbox, for a program that nobody vouches for.

May import: `bugbot.run`, `bugbot.trace`, `bugbot.worlds`, `sandbox`.
"""

from __future__ import annotations

import json
from dataclasses import asdict

from bugbot.run import Limits
from bugbot.trace import Trace, TraceError
from bugbot.worlds import World
from sandbox.node import Sandbox

__all__ = ["run_shut_in"]

_LONGEST_S = 3600.0
"""Real seconds, whatever time passes in the simulation."""

_ENDED = {
    "time": "Stopped: it computed on and on. Is there a loop that never ends, or never waits?",
    "crash": "Stopped: Python broke down. Does a function call itself without end?",
}


def run_shut_in(source: str, world: World, seed: int, limits: Limits, name: str) -> Trace:
    """The trace of the run. If its interpreter broke or had to be ended, it has an end alone.

    Raises `sandbox.node.NoSandboxError` where there is no sandbox.
    """
    job = {
        "id": "run",
        "kind": "free run",
        "name": name,
        "world": world.to_dict(),
        "seed": seed,
        "limits": {**asdict(limits), "real_s": _LONGEST_S},
    }
    trace = Trace(source, world.to_dict(), seed)
    with Sandbox() as sandbox:
        result = sandbox.perform(job, source)
    record = result.get("trace")
    if not isinstance(record, dict):
        how = str(result.get("died"))
        trace.add("end", 0.0, "limit", _ENDED.get(how, f"Stopped: {how}"))
        return trace
    try:
        rows = json.loads(record["events"])
        lines = [trace.header, *rows, ["points", record["points"]]]
        return Trace.load(map(json.dumps, lines))
    except (KeyError, TypeError, ValueError, TraceError) as error:
        # Made beside a stranger's program: it may be anything.
        trace.add("end", 0.0, "limit", f"Stopped: what the run left can't be read ({error})")
        return trace
