"""Running a program: (program, world, seed) -> trace.

May import: the rest of `bugbot`.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from types import ModuleType
from typing import Any, TextIO, cast

from bugbot import worlds
from bugbot.link import Link, connected
from bugbot.run.console import Print, Screen
from bugbot.run.faults import fault_of, learner_lines
from bugbot.run.host import hosted
from bugbot.run.limits import LimitReached, Limits, Meter
from bugbot.run.slips.quiet import remarks
from bugbot.run.watchdog import Still, watched
from bugbot.trace import Trace, storable
from bugbot.worlds import World

__all__ = ["LEFT", "run_program"]

LEFT = "the program left"
"""In the message of the end of a program that called exit()."""

_USUAL_LIMITS = Limits()

_LONGEST_GOODBYE = 1000
"""So much of the text given to sys.exit() is shown [characters]."""


def run_program(
    source: str,
    world: World | dict[str, Any] | str,
    seed: int,
    *,
    limits: Limits = _USUAL_LIMITS,
    filename: str = "program.py",
    on_flush: Callable[[], None] | None = None,
    trace_ready: Callable[[Trace], None] | None = None,
    on_stuck: Callable[[Trace], None] | None = None,
    on_still: Still | None = None,
    on_print: Print | None = None,
    then: Callable[[ModuleType], None] | None = None,
) -> Trace:
    """Run a program on a world and return its trace.

    source       the program's text
    world        a World, the data of a world's file, or a name or path for `worlds.load`
    seed         of every noise and of the program's own `random`
    limits       what the run may use up
    filename     what the program is called in messages
    on_flush     called often while the program runs, from the robot's calls and from printing
    trace_ready  is handed the trace before the program starts
    on_stuck     called from another thread, with the trace at its end, if the program computes
                 past the limit and can't be interrupted; it should end the process
    on_still     called, once a standstill, when the program has computed for `STILL_S` of real
                 time and no simulated time has passed; is told the line. No part of the trace
    on_print     called with all that is printed, at once: for a host whose interpreter may break
    then         called with the program's module when the program has come to its end or was
                 ended, by an error, exit() or a limit, still as a part of the run

    The same arguments give the same trace. Whatever the program does wrong is in the trace
    (`fault` and `end` events), never raised. Raises WorldError for a world that is none, and
    TypeError for a seed that is no int.
    """
    if not isinstance(seed, int):
        raise TypeError(f"a run wants an int for its seed; it got {seed!r}")
    if not isinstance(world, World):
        world = World.from_dict(world) if isinstance(world, dict) else worlds.load(world)
    source = storable(source.removeprefix("\ufeff"))  # what some editors put before the text
    trace = Trace(source, world.to_dict(), seed)
    meter = Meter(limits, trace, filename, on_flush)
    link = Link(world, seed, trace, filename, meter)
    if trace_ready is not None:
        trace_ready(trace)
    module = ModuleType("__main__")
    module.__file__ = filename
    out = Screen("stdout", trace, link.now, meter, on_print)
    err = Screen("stderr", trace, link.now, meter, on_print)

    def end(status: str, message: str) -> None:
        link.sim.finish()
        trace.add("end", link.now(), status, message)

    def give_up() -> None:
        end(*_over(meter))
        if on_stuck is not None:
            on_stuck(trace)

    give_up_at = give_up if on_stuck else None
    with connected(link), watched(meter, link.now, filename, give_up_at, on_still):
        with hosted(module, source, seed, link, out, err):
            error = _carry_out(source, module, filename, then, meter)
        # Python is the host's again, whatever the program has done to it. But the text of an
        # error may be made by the learner's own code, which may print, or never end.
        with redirect_stdout(cast(TextIO, out)), redirect_stderr(cast(TextIO, err)):
            try:
                ending = _ending(error, source, link, meter)
            except LimitReached:
                ending = _over(meter)
    end(*ending)
    return trace


def _carry_out(
    source: str,
    module: ModuleType,
    filename: str,
    then: Callable[[ModuleType], None] | None,
    meter: Meter,
) -> BaseException | None:
    """Run the program in its module; what ended it, or None if it came to its end."""
    failed: BaseException | None = None
    try:
        try:
            exec(compile(source, filename, "exec", dont_inherit=True), vars(module))
        except KeyboardInterrupt:
            raise
        except BaseException as error:
            failed = error
        if then is not None:
            with meter.set_aside():
                then(module)
    except BaseException as error:
        return error
    return failed


def _ending(error: BaseException | None, source: str, link: Link, meter: Meter) -> tuple[str, str]:
    """Status and message of the end; records the fault if there is one."""
    if meter.over is not None:  # whatever the program made of it on the way out
        return _over(meter)
    if error is None:
        return "finished", " ".join([f"Finished after {_seconds(link)}.", *remarks(source, link)])
    lines = learner_lines(error, link.filename)
    on_line = f" on line {lines[-1]}" if lines else ""
    if isinstance(error, SystemExit):
        if isinstance(error.code, str):  # as Python does at the command line
            goodbye = storable(error.code[:_LONGEST_GOODBYE])
            link.trace.write(link.now(), "stderr", f"{goodbye}\n")
        return "finished", f"Finished after {_seconds(link)}: {LEFT}{on_line}."
    if isinstance(error, KeyboardInterrupt):
        return "stopped", f"Stopped{on_line} after {_seconds(link)}."
    fault = fault_of(error, source, link.filename)
    link.trace.add(
        "fault", link.now(), fault.type, fault.message, fault.line, fault.hint, fault.traceback
    )
    where = "" if fault.line is None else f" on line {fault.line}"
    return "fault", f"Stopped by an error{where}: {fault.message}"


def _over(meter: Meter) -> tuple[str, str]:
    on_line = "" if meter.line is None else f" on line {meter.line}"
    return "limit", f"Stopped{on_line} {meter.over}"


def _seconds(link: Link) -> str:
    return f"{round(link.now(), 2):g} s"
