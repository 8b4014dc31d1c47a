"""The clocks of Python's library besides `time`: all but timeit() follow simulated time.

May import: the standard library, `bugbot.link`, `bugbot.own_clock`, the rest of `bugbot.run`.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import ExitStack
from types import ModuleType
from typing import Any

from bugbot.link import Link
from bugbot.own_clock import EPOCH_S
from bugbot.run.on_import import Change, put_back

__all__ = ["clocks_elsewhere"]

_real_clock = time.perf_counter
"""For timeit(), whose one purpose is to measure how long the computer takes."""


def clocks_elsewhere(link: Link, sleep: Callable[[Any], None]) -> dict[str, Change]:
    """The modules that have a clock of their own, or have taken one from `time`."""

    def asyncio(package: ModuleType, undo: ExitStack) -> None:
        # With it come a dozen modules: only programs that use it should wait for them.
        from bugbot.run.event_loop import use_simulated_loops

        use_simulated_loops(package, undo, link)

    def dates(module: ModuleType, undo: ExitStack) -> None:
        from bugbot.run.dates import simulated_dates

        put_back(module, undo)
        vars(module).update(simulated_dates(link.now))

    def logging(package: ModuleType, undo: ExitStack) -> None:
        put_back(package, undo)
        undo.callback(setattr, package.Formatter, "converter", package.Formatter.converter)
        package.Formatter.converter = staticmethod(time.gmtime)
        start = round(EPOCH_S * 1e9) if isinstance(package._startTime, int) else EPOCH_S
        vars(package).update(_startTime=start)

    def queue(module: ModuleType, undo: ExitStack) -> None:
        put_back(module, undo)
        vars(module).update(time=link.now)

    def sched(module: ModuleType, undo: ExitStack) -> None:
        make = module.scheduler.__init__
        undo.callback(setattr, make, "__defaults__", make.__defaults__)
        make.__defaults__ = (link.now, sleep)

    def timeit(module: ModuleType, undo: ExitStack) -> None:
        put_back(module, undo)
        for function in (module.Timer.__init__, module.timeit, module.repeat):
            undo.callback(setattr, function, "__defaults__", function.__defaults__)
            function.__defaults__ = tuple(
                _real_clock if callable(each) else each for each in function.__defaults__
            )
        vars(module).update(default_timer=link.now)

    return {
        "asyncio": asyncio,
        "datetime": dates,
        "logging": logging,
        "queue": queue,
        "sched": sched,
        "timeit": timeit,
    }
