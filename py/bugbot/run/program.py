"""Running a program: (program, world, seed) -> trace.

May import: the rest of `bugbot`.
"""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType
from typing import Any

from bugbot import worlds
from bugbot.link import Link, connected
from bugbot.run.console import Screen
from bugbot.run.faults import fault_of
from bugbot.run.host import hosted
from bugbot.run.limits import LimitReached, Limits, Meter
from bugbot.trace import Trace
from bugbot.worlds import World

__all__ = ["run_program"]


def run_program(
    source: str,
    world: World | dict[str, Any] | str,
    seed: int,
    *,
    limits: Limits = Limits(),  # noqa: B008  frozen
    filename: str = "program.py",
    on_flush: Callable[[], None] | None = None,
    trace_ready: Callable[[Trace], None] | None = None,
) -> Trace:
    """Run a program on a world and return its trace.

    source       the program's text
    world        a World, the data of a world's file, or a name or path for `worlds.load`
    seed         of every noise and of the program's own `random`
    limits       what the run may use up
    filename     what the program is called in messages
    on_flush     called often while the program runs, from the robot's calls and from printing
    trace_ready  is handed the trace before the program starts

    The same arguments give the same trace. Whatever the program does wrong is in the trace
    (`fault` and `end` events), never raised. Raises WorldError for a world that is none.
    """
    if not isinstance(world, World):
        world = World.from_dict(world) if isinstance(world, dict) else worlds.load(world)
    source = source.removeprefix("\ufeff")
    trace = Trace(source, world.to_dict(), seed)
    meter = Meter(limits, trace, on_flush)
    link = Link(world, seed, trace, filename, meter)
    if trace_ready is not None:
        trace_ready(trace)
    module = ModuleType("__main__")
    module.__file__ = filename
    screens = (
        Screen("stdout", trace, link.now, meter),
        Screen("stderr", trace, link.now, meter),
    )
    with connected(link), hosted(module, source, filename, seed, screens, link.now, link.advance):
        status, message = _carry_out(source, module, link)
    link.sim.finish()
    trace.add("end", link.now(), status, message)
    return trace


def _carry_out(source: str, module: ModuleType, link: Link) -> tuple[str, str]:
    """Run the program in its module; the status and message of its end."""
    try:
        exec(compile(source, link.filename, "exec", dont_inherit=True), vars(module))
    except SystemExit:
        return "finished", f"Finished after {link.now():g} s."
    except LimitReached as limit:
        return "limit", f"Stopped {limit}."
    except BaseException as error:
        fault = fault_of(error, link.filename)
        link.trace.add(
            "fault", link.now(), fault.type, fault.message, fault.line, fault.hint, fault.traceback
        )
        return "fault", f"Stopped by an error on line {fault.line}: {fault.message}"
    return "finished", f"Finished after {link.now():g} s."
