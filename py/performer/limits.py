"""What marking a program may use up.

May import: nothing.
"""

from __future__ import annotations

from typing import Any

__all__ = [
    "AGAIN_S",
    "CALLS_LIMITS",
    "CALL_S",
    "FEW_LINES_A_S",
    "PROGRAM_S",
    "RUN_LIMITS",
    "SLOW",
]

RUN_LIMITS: dict[str, Any] = {
    "simulated_s": 120.0,
    "silent_s": 10.0,
    "print_bytes": 200_000,
    "trace_bytes": 24_000_000,
    "real_s": 60.0,
}
"""Of a run; each check names its own simulated seconds. `real_s` is for whoever runs the
performer: after so many seconds the interpreter is ended, of the processor where the system counts
them, else by the clock."""

CALLS_LIMITS = {**RUN_LIMITS, "silent_s": 600.0, "real_s": 60.0}
"""A program is ended after PROGRAM_S, and its functions are called then; `real_s` is for what
computes inside one single line. Silence is counted by the clock on the wall, so it is only for a
job that waits for ever."""

PROGRAM_S = 10.0
"""Seconds of the processor that a program may take to its end before its functions are called."""

AGAIN_S = 1.0
"""The same, once it has taken that: what it defines is there long before."""

CALL_S = 2.0
"""Seconds of the processor that one call of a learner's function may take."""

FEW_LINES_A_S = 2000
"""A program whose time is over, and which from then on gets through fewer lines than this for each
second that it had, is in no endless loop of its own: it is still importing a module, or the machine
is slow or busy with other things."""

SLOW = 5
"""Such a program has so many times as long."""
