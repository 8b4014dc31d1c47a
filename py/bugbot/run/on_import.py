"""Changes to a module as soon as a program imports it, undone after the run.

May import: the standard library.

What is loaded already is changed at once. The rest waits for its import: nobody should wait
for NumPy or asyncio whose program does without them.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any

__all__ = ["Change", "changed_on_import", "put_back"]

Change = Callable[[ModuleType, ExitStack], None]
"""Changes a module that has just been loaded; leaves on the stack what undoes it."""


@contextmanager
def changed_on_import(
    changes: Mapping[str, Change], around: Callable[[], Any] | None = None
) -> Iterator[None]:
    """Inside this block each of the named modules is changed as soon as it is there.

    around  called before a module is loaded; what it returns is called when that is done
    """
    with ExitStack() as undo:
        waiting = dict(changes)
        for name in [name for name in waiting if name in sys.modules]:
            waiting.pop(name)(sys.modules[name], undo)
        finder = _Finder(waiting, undo, around)
        sys.meta_path.insert(0, finder)
        undo.callback(_remove, finder)
        yield


def put_back(module: ModuleType, undo: ExitStack) -> None:
    """Have the module's names as they are now put back at the end."""
    undo.callback(vars(module).update, dict(vars(module)))


def _remove(finder: MetaPathFinder) -> None:
    if finder in sys.meta_path:
        sys.meta_path.remove(finder)


class _Finder(MetaPathFinder):
    """Finds nothing itself: has the others find, and is told when the module has been loaded."""

    def __init__(
        self, waiting: dict[str, Change], undo: ExitStack, around: Callable[[], Any] | None
    ) -> None:
        self._waiting = waiting
        self._undo = undo
        self._around = around

    def find_spec(self, name: str, path: Any, target: Any = None) -> ModuleSpec | None:
        if name not in self._waiting:
            return None
        for finder in sys.meta_path:
            spec = None if finder is self else finder.find_spec(name, path, target)
            if spec is not None and spec.loader is not None:
                change = self._waiting.pop(name)
                spec.loader = _Telling(spec.loader, change, self._undo, self._around)
                return spec
        return None


class _Telling(Loader):
    """Loads as another loader does, then has the module changed."""

    def __init__(
        self,
        real: Any,
        change: Change,
        undo: ExitStack,
        around: Callable[[], Any] | None,
    ) -> None:
        self._real = real
        self._change = change
        self._undo = undo
        self._around = around

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        made: ModuleType | None = self._real.create_module(spec)
        return made

    def exec_module(self, module: ModuleType) -> None:
        module.__loader__ = self._real
        if module.__spec__ is not None:
            module.__spec__.loader = self._real
        loaded = self._around() if self._around is not None else None
        self._real.exec_module(module)
        if loaded is not None:
            loaded()
        self._change(module, self._undo)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._real, name)
