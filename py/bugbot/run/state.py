"""All that can make a difference to what a function of the program does next, as one value.

May import: the standard library, `bugbot.api`.

Two equal states at the same instruction mean that the program repeats itself. Whatever can't be
looked into, an iterator or an open file, makes the state unknown: then nothing is said.
"""

from __future__ import annotations

import random
from collections import deque
from types import BuiltinFunctionType, CodeType, FrameType, FunctionType, MethodType, ModuleType
from typing import Any

from bugbot.api import Robot

__all__ = ["UnknownError", "state_of"]

_MOST_PARTS = 20_000
_LONGEST_TEXT = 10_000
_PLAIN = (bool, int, float, complex, str, bytes, type(None), type(...), range)
_RANDOM: Any = vars(random)["_inst"]
"""The generator whose methods the functions of `random` are."""

_KNOWN_MODULES = {
    *("bugbot", "builtins", "cmath", "collections", "copy", "dataclasses", "datetime", "enum"),
    *("fractions", "functools", "json", "math", "operator", "random", "statistics", "string"),
    *("sys", "time", "typing", "__future__"),
}
"""Modules without a state of their own that could change an answer, or whose state is looked at."""


class UnknownError(Exception):
    """The state holds something that can't be looked into."""


def state_of(frame: FrameType) -> object:
    """The names in sight of the frame, what they hold, and the state of `random`."""
    reader = _Reader(frame.f_code.co_filename)
    names = frame.f_locals if frame.f_locals is frame.f_globals else dict(frame.f_locals)
    local = reader.read(names)
    return local, reader.read(frame.f_globals), random.getstate()


class _Reader:
    def __init__(self, filename: str) -> None:
        self._filename = filename
        self._seen: dict[int, tuple[int, object]] = {}
        """By id: its number, and the value itself, so that no other gets the same id."""
        self._parts = 0

    def read(self, value: Any) -> object:
        """The value in a form that can be compared; UnknownError if there is none."""
        self._parts += 1
        if self._parts > _MOST_PARTS:
            raise UnknownError
        kind = type(value)
        if kind in _PLAIN:
            if kind in (str, bytes) and len(value) > _LONGEST_TEXT:
                raise UnknownError
            return kind, repr(value) if kind in (float, complex) else value
        if id(value) in self._seen:
            return "again", self._seen[id(value)][0]
        self._seen[id(value)] = len(self._seen), value
        return kind, self._inside(kind, value)

    def _inside(self, kind: type, value: Any) -> object:
        if kind in (list, tuple, deque):
            return [self.read(each) for each in value]
        if kind is dict:
            return [
                (self.read(key), self.read(each))
                for key, each in value.items()
                if not (isinstance(key, str) and key.startswith("__") and key.endswith("__"))
            ]
        if kind in (set, frozenset):
            # In the order that the set has: after the same steps it is the same.
            return [self.read(each) for each in value]
        if kind is FunctionType:
            return self._function(value)
        if kind is MethodType:
            return self.read(value.__self__), self.read(value.__func__)
        if kind is BuiltinFunctionType:
            return id(value), self._owner(value.__self__)
        if kind is ModuleType:
            return self._owner(value)
        if isinstance(value, type):
            return self._type(value)
        if value is _RANDOM:
            return "random"
        if kind is Robot:
            return None
        if kind.__module__ == "__main__" and not hasattr(kind, "__slots__"):
            if issubclass(kind, list | dict | set | tuple | str | int | float):
                raise UnknownError
            return self.read(kind), self.read(vars(value))
        raise UnknownError

    def _function(self, function: FunctionType) -> object:
        code: CodeType = function.__code__
        if code.co_filename != self._filename:
            if function.__module__.partition(".")[0] not in _KNOWN_MODULES:
                raise UnknownError
            return id(function)
        try:
            cells = [each.cell_contents for each in function.__closure__ or ()]
        except ValueError:  # one that has nothing in it yet
            raise UnknownError from None
        return id(code), self.read(cells), self.read(list(function.__defaults__ or ()))

    def _type(self, kind: type) -> object:
        if kind.__module__ == "__main__":
            return [self.read(each) for name, each in vars(kind).items() if name[:2] != "__"]
        if kind.__module__.partition(".")[0] not in _KNOWN_MODULES:
            raise UnknownError
        return id(kind)

    def _owner(self, owner: Any) -> object:
        """What a builtin function belongs to: a module without a state, or a value."""
        if isinstance(owner, ModuleType):
            if owner.__name__.partition(".")[0] not in _KNOWN_MODULES:
                raise UnknownError
            return owner.__name__
        return self.read(owner)
