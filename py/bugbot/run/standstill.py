"""Finds a loop that goes on for ever because no simulated time passes in it.

May import: the standard library, `bugbot.run.state`.

`while distance() > 20: pass` asks for ever: without a wait() the robot stays where it is. Such a
run is ended early, and only by what the program does, never by real time, so the same program
still leaves the same trace. Two things end it:

* **a proof**: a while loop comes back to the same instruction with everything as it was;
* **a count**: a while loop has used the depth sensor `MOST_LOOKS` times at one moment. Noise makes
  every reading new, so nothing can be proved there.

A loop over a list or a range ends by itself, one that counts will, and calculating takes no
simulated time: none of them is ended here.
"""

from __future__ import annotations

import ast
import warnings
from collections.abc import Iterator
from itertools import islice
from types import FrameType
from typing import Any

from bugbot.run.state import UnknownError, state_of

__all__ = ["MOST_LOOKS", "Standstill"]

MOST_LOOKS = 10_000
"""Readings of the depth sensor at one moment that a while loop may take."""

_ROUND_A_FOR = 4
"""So many times as many if a for loop in the while loop takes them."""

_FIRST_TRY = 2_000
"""Calls at one moment after which a proof is tried; then again at twice as many."""

_TRIES = 400
"""For so many calls a loop is given the chance to come back to where it was."""

_MEASURE = {"battery", "clock", "distance", "heading", "odometry", "position", "scan"}

_HIDES_STATE = 0x20 | 0x80 | 0x100 | 0x200
"""Flags of generators and coroutines: what goes on between their steps can't be seen."""

_FOR = (ast.For, ast.AsyncFor, ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)
_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)


class Standstill:
    """Counts what a program does while no simulated time passes.

    `looked` and `called` return the reason to end the run, or None.
    """

    def __init__(self, source: str, filename: str) -> None:
        self._source = source
        self._filename = filename
        self._nodes: tuple[list[Any], list[Any]] | None = None
        self.time_passed()

    def time_passed(self) -> None:
        """Begin to count anew."""
        self._calls = self._looks = 0
        self._try_at, self._judge_at = _FIRST_TRY, MOST_LOOKS // 2
        self._tallies: dict[ast.While, list[int]] = {}
        self._seen: tuple[tuple[FrameType, int, int], object] | None = None

    def looked(self, frame: FrameType) -> str | None:
        """The depth sensor is used, in this frame or one that called it."""
        self._looks += 1
        if self._looks < self._judge_at:
            return None
        self._judge_at *= 2
        most = MOST_LOOKS
        for each in self._learners(frame):
            for loop in self._loops_round(each):
                if not isinstance(loop, ast.While):
                    most = _ROUND_A_FOR * MOST_LOOKS
                elif not self._counts(loop, each) and self._looks >= most:
                    return (
                        f"at {{now}} s: the depth sensor was used {self._looks:,} times and no "
                        f"simulated time passed, so the robot stayed where it is. {_wait_in(loop)}"
                    )
        return None

    def _counts(self, loop: ast.While, frame: FrameType) -> bool:
        """Whether a number or a length that the loop asks about has changed since last time."""
        tally = [
            value if isinstance(value, int) else len(value)
            for each in ast.walk(loop.test)
            if isinstance(each, ast.Name)
            for value in (frame.f_locals.get(each.id, frame.f_globals.get(each.id)),)
            if isinstance(value, int | list | dict | set)
        ]
        before = self._tallies.get(loop)
        self._tallies[loop] = tally
        return before != tally

    def called(self, frame: FrameType) -> str | None:
        """A call of the robot's is made, or something printed."""
        self._calls += 1
        if self._calls < self._try_at:
            return None
        if self._calls > self._try_at + _TRIES:
            self._try_at, self._seen = 2 * self._calls, None
            return None
        inner = next(self._learners(frame), None)
        if inner is None or inner.f_code.co_flags & _HIDES_STATE:
            return None
        place = (inner, inner.f_lasti, self._looks)  # each look has noise, which makes a difference
        if self._seen is not None and self._seen[0] != place:
            return None
        loop = next(self._loops_round(inner), None)
        if not isinstance(loop, ast.While):
            return None
        try:
            state = state_of(inner)
        except UnknownError:
            return None
        if self._seen is None:
            self._seen = (place, state)
            return None
        return _repeats(loop, inner) if state == self._seen[1] else None

    # -- where in the program ------------------------------------------------------

    def _learners(self, frame: FrameType | None) -> Iterator[FrameType]:
        """The frames of the program, innermost first."""
        while frame is not None:
            if frame.f_code.co_filename == self._filename:
                yield frame
            frame = frame.f_back

    def _loops_round(self, frame: FrameType) -> Iterator[Any]:
        """The loops round the frame's line, in the frame's own function, innermost first."""
        loops, functions = self._read()
        point = _point(frame)
        begin = max((_start(each) for each in functions if _spans(each, point)), default=(0, 0))
        round_it = [each for each in loops if _repeated(each, point) and _start(each) >= begin]
        return iter(sorted(round_it, key=_start, reverse=True))

    def _read(self) -> tuple[list[Any], list[Any]]:
        if self._nodes is None:
            with warnings.catch_warnings():  # they have been shown when the program was compiled
                warnings.simplefilter("ignore")
                every = list(ast.walk(ast.parse(self._source)))
            loops = [each for each in every if isinstance(each, (ast.While, *_FOR))]
            self._nodes = loops, [each for each in every if isinstance(each, _FUNCTIONS)]
        return self._nodes


def _point(frame: FrameType) -> tuple[int, int]:
    """Line and column of what the frame is carrying out."""
    positions = islice(frame.f_code.co_positions(), frame.f_lasti // 2, None)
    line, _, column, _ = next(positions, (None, None, None, None))
    return line or frame.f_lineno, column or 0


def _start(node: Any) -> tuple[int, int]:
    return node.lineno, node.col_offset


def _spans(node: Any, point: tuple[int, int]) -> bool:
    return _start(node) <= point < (node.end_lineno, node.end_col_offset)


def _repeated(loop: Any, point: tuple[int, int]) -> bool:
    """Whether what stands at this point is done again and again in the loop."""
    # What a for loop or a comprehension goes through is worked out once, before it.
    once = loop.generators[0].iter if hasattr(loop, "generators") else getattr(loop, "iter", None)
    return _spans(loop, point) and not (once is not None and _spans(once, point))


def _wait_in(loop: ast.While) -> str:
    return f"Put wait(0.1) into the loop on line {loop.lineno}."


def _repeats(loop: ast.While, frame: FrameType) -> str:
    """Why a loop that repeats itself is ended, and what it lacks."""
    called = {
        each.func.attr if isinstance(each.func, ast.Attribute) else getattr(each.func, "id", None)
        for each in ast.walk(loop)
        if isinstance(each, ast.Call)
    }
    if called & _MEASURE:
        return (
            f"at {{now}} s: the loop on line {loop.lineno} asks again and again and no simulated "
            f"time passes, so the answer stays the same. {_wait_in(loop)}"
        )
    asked = [each.id for each in ast.walk(loop.test) if isinstance(each, ast.Name)]
    numbers = [name for name in asked if type(frame.f_locals.get(name)) in (int, float)]
    change = f"change {numbers[0]} in it" if numbers else "have something in it change"
    return (
        f"at {{now}} s: the loop on line {loop.lineno} does the same again and again, and no "
        f"simulated time passes. If it counts, {change}; if it waits for the robot, put wait(0.1) "
        "into it."
    )
