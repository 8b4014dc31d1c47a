"""Does one job in an interpreter of its own: runs the learner's program, calls its functions.

May import: the standard library, `bugbot`, the rest of `performer`.

Nothing that would tell what is right is here: what comes back is what the program did and
answered, and whether that is right is judged elsewhere. The interpreter is ended afterwards
by whoever started it, and so nothing of what a program did to it outlives the job.
"""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Callable
from functools import partial
from typing import Any

from bugbot.run.limits import Limits
from bugbot.run.program import LEFT, run_program
from bugbot.trace import Trace
from performer.calling import Caller
from performer.constants import unwritten, with_constants
from performer.fence import fenced
from performer.limits import AGAIN_S, PROGRAM_S
from performer.patience import Patience
from performer.refusal import refusal
from performer.values import decoded

__all__ = ["PROGRAM", "perform"]

PROGRAM = "program.py"
"""What the learner's program is called in messages."""

_MOST_LATE = 2
"""After so many groups with a call that never came back, the others are not begun."""


def perform(
    job: dict[str, Any], program: str, on_flush: Callable[[], None] | None = None
) -> dict[str, Any]:
    """Do a job with a learner's program; jobs and results are described in `grader.jobs`.

    A job of the kind "free run" is no part of a marking: the program may use what it may in a lab.

    on_flush  called often during a run, from the robot's calls and from printing: a page hears
              by it that the program still gets on
    """
    if job["kind"] == "free run":
        return _run(job, program, on_flush)
    refused = refusal(program)
    if refused is not None:
        return _result(job, died=refused)
    with fenced(PROGRAM):
        if job["kind"] == "run":
            return _run(job, program, on_flush)
        return _calls(job, program)


def _result(job: dict[str, Any], **parts: Any) -> dict[str, Any]:
    empty = {"trace": None, "outcome": None, "answers": None, "died": None}
    return {"id": job["id"], **empty, **parts}


def _limits(job: dict[str, Any]) -> Limits:
    limits = job["limits"]
    return Limits(
        simulated_s=limits["simulated_s"],
        silent_s=limits["silent_s"],
        print_bytes=limits["print_bytes"],
        trace_bytes=limits["trace_bytes"],
    )


def _run(job: dict[str, Any], program: str, on_flush: Callable[[], None] | None) -> dict[str, Any]:
    trace = run_program(
        program,
        job["world"],
        job["seed"],
        limits=_limits(job),
        filename=job.get("name", PROGRAM),
        trace_ready=_keep_moves,
        on_flush=on_flush,
    )
    end = _end_of(trace)
    moves = trace.moves
    events, points = trace.take()
    record = {"events": events, "points": b64encode(points).decode("ascii"), "moves": moves}
    return _result(job, trace=record, outcome=end)


def _keep_moves(trace: Trace) -> None:
    trace.moves = []


def _end_of(trace: Trace) -> dict[str, Any]:
    end = next(trace.of_kind("end"))
    return {"status": end["status"], "seconds": end["t"], "message": end["message"]}


def _calls(job: dict[str, Any], program: str) -> dict[str, Any]:
    answers: list[dict[str, Any]] = []
    late = 0
    seconds = PROGRAM_S
    first_on: int | None = None
    for group in job["groups"]:
        if late >= _MOST_LATE:
            answers.append({"skipped": True})
            continue
        constants = {name: decoded(value) for name, value in group["constants"].items()}
        changed = with_constants(program, constants)
        patience = Patience(PROGRAM)
        names = unwritten(program, constants)
        caller = Caller(group["calls"], changed, PROGRAM, patience, names)
        run = partial(
            run_program,
            changed,
            group["world"],
            group["seed"],
            limits=_limits(job),
            filename=PROGRAM,
            trace_ready=caller.follow,
            on_flush=patience.look,
            then=caller.make_calls,
        )
        with patience:
            trace = patience.have(run, seconds)
        late += caller.late
        stopped_on = caller.stopped_on
        if stopped_on is not None:  # the program itself went on and on: so it does every time
            seconds = AGAIN_S
            first_on = stopped_on if first_on is None else first_on
        answers.append(_reply(trace, caller, None if stopped_on is None else first_on))
    return _result(job, answers=answers)


def _reply(trace: Trace, caller: Caller, stopped_on: int | None) -> dict[str, Any]:
    """What a group came to: how the program ended, and the answers up to then.

    stopped_on  the line told if the program computed for too long, the same for every group
    """
    fault = next(trace.of_kind("fault"), None)
    end = _end_of(trace)
    reply = {
        **end,
        "left": LEFT in end["message"],
        "answers": caller.answers,
        "fault": fault and {key: fault[key] for key in ("type", "message", "line", "hint")},
    }
    if stopped_on is not None:
        words = (
            f"Stopped on line {stopped_on} after {PROGRAM_S:g} s of computing: "
            "it is very slow, or it has a loop that never ends."
        )
        return {**reply, "status": "limit", "message": words, "fault": None}
    return reply
