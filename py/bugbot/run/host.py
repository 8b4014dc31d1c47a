"""Python as a program finds it during a run, and put back as it was afterwards.

May import: the standard library, `bugbot.own_clock`, `bugbot.checks`, `bugbot.errors`,
`bugbot.link`, the rest of `bugbot.run`.

A program may do as it likes with `random`, `time`, `builtins` and the rest: the
same program must give the same trace whatever ran before it, and the host (a
test, the grader, the command line) must go on unharmed.
"""

from __future__ import annotations

import builtins
import linecache
import math
import os
import random
import sys
import threading
import time
import warnings
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from types import FrameType, ModuleType
from typing import Any, NoReturn, TextIO, cast

import bugbot
from bugbot import api, checks
from bugbot.link import Link
from bugbot.own_clock import simulated_time
from bugbot.run.chance import SeededChance
from bugbot.run.clocks import clocks_elsewhere
from bugbot.run.console import NoKeyboard, Screen, no_debugger, no_input
from bugbot.run.on_import import changed_on_import
from bugbot.run.slips.case import lines_of
from bugbot.run.threads import no_threads

__all__ = ["hosted"]

_RESTORED = (api, bugbot, builtins, math, os, random, sys, threading, time)
"""Modules whose names a program may have replaced: all are put back."""

_RECURSION = 900
"""Calls inside one another that a program has, whoever runs it; below what engines can bear."""


@contextmanager
def hosted(
    module: ModuleType, source: str, seed: int, link: Link, out: Screen, err: Screen
) -> Iterator[None]:
    """Inside this block Python is the program's; afterwards it is as before."""
    filename = link.filename
    with ExitStack() as undo:
        for each in _RESTORED:
            undo.callback(_put_back, vars(each), dict(vars(each)))
        undo.callback(_put_back_entry, sys.modules, "__main__", sys.modules.get("__main__"))
        undo.callback(_put_back_entry, linecache.cache, filename, linecache.cache.get(filename))
        undo.callback(sys.setrecursionlimit, sys.getrecursionlimit())
        undo.callback(sys.settrace, sys.gettrace())
        undo.enter_context(warnings.catch_warnings())
        sleep = _sleeper(link)
        undo.enter_context(simulated_time(link.now, sleep))
        undo.enter_context(no_threads(sleep))
        chance = SeededChance(seed)
        undo.enter_context(chance.at_work())
        changes = {**clocks_elsewhere(link, sleep), **chance.changes()}
        undo.enter_context(changed_on_import(changes, chance.while_loading))

        sys.modules["__main__"] = module
        lines = [f"{line}\n" for line in lines_of(source)]
        linecache.cache[filename] = (len(source), None, lines, filename)
        sys.setrecursionlimit(_depth() + _RECURSION)
        sys.stdout, sys.stderr = cast(TextIO, out), cast(TextIO, err)
        sys.stdin = cast(TextIO, NoKeyboard())
        sys.breakpointhook = no_debugger
        sys.argv, sys.path = [filename], sys.path[:]
        vars(builtins).update(input=no_input, exit=sys.exit, quit=sys.exit)
        vars(os).update(_exit=_leave, abort=_leave)
        _show_warnings_in(filename)
        yield


def _sleeper(link: Link) -> Any:
    def sleep(seconds: Any) -> None:
        """time.sleep() during a run: simulated time passes."""
        call = "time.sleep(seconds)"
        link.check()
        link.advance(checks.number(call, "seconds", seconds, "a number of 0 or more", low=0.0))

    return sleep


def _leave(status: object = None) -> NoReturn:
    """os._exit() during a run: the end of the program, not of its host."""
    raise SystemExit(status)


def _depth() -> int:
    depth = 0
    frame: FrameType | None = sys._getframe()
    while frame is not None:
        depth += 1
        frame = frame.f_back
    return depth


def _show_warnings_in(program: str) -> None:
    """Python's own rules for what is shown, whatever the host has set; on the program's stderr."""

    def show(
        message: Warning | str,
        category: type[Warning],
        filename: str,
        lineno: int,
        file: TextIO | None = None,
        line: str | None = None,
    ) -> None:
        where = f"Line {lineno}" if filename == program else filename
        sys.stderr.write(f"{where}: {category.__name__}: {message}\n")

    warnings.showwarning = show
    warnings.resetwarnings()
    for quiet in (
        DeprecationWarning,
        PendingDeprecationWarning,
        ImportWarning,
        ResourceWarning,
    ):
        warnings.simplefilter("ignore", quiet)
    # Of 2(x) it says that a comma is missing; the error says what is.
    warnings.filterwarnings("ignore", ".* is not callable; perhaps", SyntaxWarning)
    warnings.filterwarnings("default", category=DeprecationWarning, module="__main__")


def _put_back(current: dict[str, Any], names: dict[str, Any]) -> None:
    for name in [name for name in current if name not in names]:
        del current[name]
    current.update(names)


def _put_back_entry(table: dict[str, Any], key: str, value: Any) -> None:
    if value is None:
        table.pop(key, None)
    else:
        table[key] = value
