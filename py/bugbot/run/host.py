"""Python as a program finds it during a run, and put back as it was afterwards.

May import: the standard library, `bugbot.clock`, `bugbot.run.console`.

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
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from types import ModuleType
from typing import Any, NoReturn, TextIO, cast

import bugbot
from bugbot import api
from bugbot.clock import simulated_time
from bugbot.run.console import NoKeyboard, Screen, no_input

__all__ = ["hosted"]

_RESTORED = (builtins, math, os, random, sys, threading, time, bugbot, api)
"""Modules whose names a program may have replaced: all are put back."""

_RECURSION = 1000
"""Python's own default, so that runaway recursion ends at the same depth everywhere."""


@contextmanager
def hosted(
    module: ModuleType,
    source: str,
    filename: str,
    seed: int,
    screens: tuple[Screen, Screen],
    now: Callable[[], float],
    sleep: Callable[[Any], None],
) -> Iterator[None]:
    """Inside this block Python is the program's; afterwards it is as before."""
    with ExitStack() as undo:
        for each in _RESTORED:
            undo.callback(_put_back, each, dict(vars(each)))
        undo.callback(random.setstate, random.getstate())
        undo.callback(sys.setrecursionlimit, sys.getrecursionlimit())
        undo.callback(sys.settrace, sys.gettrace())
        undo.callback(_put_back_entry, sys.modules, "__main__", sys.modules.get("__main__"))
        undo.callback(_put_back_entry, linecache.cache, filename, linecache.cache.get(filename))
        undo.enter_context(warnings.catch_warnings())
        undo.enter_context(simulated_time(now, sleep))
        warnings.simplefilter("default")
        random.seed(seed)
        sys.setrecursionlimit(_RECURSION)
        sys.modules["__main__"] = module
        lines = source.splitlines(keepends=True)
        linecache.cache[filename] = (len(source), None, lines, filename)
        sys.stdout, sys.stderr = (cast(TextIO, screen) for screen in screens)
        sys.stdin = cast(TextIO, NoKeyboard())
        sys.argv = [filename]
        replaced: dict[str, Any] = {"input": no_input, "exit": sys.exit, "quit": sys.exit}
        vars(builtins).update(replaced)
        vars(os).update(_exit=_leave, abort=_leave)
        yield


def _leave(status: object = None) -> NoReturn:
    """What os._exit() is during a run: the end of the program, not of its host."""
    raise SystemExit(status)


def _put_back(module: ModuleType, names: dict[str, Any]) -> None:
    current = vars(module)
    for name in [name for name in current if name not in names]:
        del current[name]
    current.update(names)


def _put_back_entry(table: dict[str, Any], key: str, value: Any) -> None:
    if value is None:
        table.pop(key, None)
    else:
        table[key] = value
