"""Closes Python's routes to JavaScript, once the interpreter is up and before a program runs.

The worker does the other half (`site/src/worker/seal-python.ts`): it removes `_ctypes`,
`_pyodide_core` and others from the interpreter's table of built-in modules, so that they can't be
recreated. Neither half has to hold: what keeps a program in is that JavaScript in the worker can do
no harm.
"""

from __future__ import annotations

import gc
import importlib
import sys
from collections.abc import Sequence
from importlib.machinery import ModuleSpec
from types import BuiltinFunctionType, ModuleType
from typing import Any

__all__ = ["seal"]

_ROUTES = frozenset(
    {"js", "pyodide", "pyodide_js", "_pyodide", "_pyodide_core", "ctypes", "_ctypes"}
)
"""Packages that lead to JavaScript or to the interpreter's own memory."""


def _is_route(name: str) -> bool:
    return name.partition(".")[0] in _ROUTES


class _NotHere:
    """Refuses to import those modules, as if they did not exist."""

    def find_spec(
        self, name: str, _path: Sequence[str] | None = None, _target: ModuleType | None = None
    ) -> ModuleSpec | None:
        if _is_route(name):
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)
        return None


def seal() -> None:
    """Remove the modules that lead out, and empty them in case a program finds one."""
    from _pyodide._importhook import jsfinder  # type: ignore[import-not-found]

    jsfinder.jsproxies.clear()
    ours: Any = _NotHere()
    kept = [finder for finder in sys.meta_path if not _is_route(getattr(finder, "__module__", ""))]
    sys.meta_path[:] = [ours, *kept]
    for name in [name for name in sys.modules if _is_route(name)]:
        module: Any = sys.modules.pop(name)
        if isinstance(module, ModuleType):
            _empty(vars(module))
    for each in gc.get_objects():
        # Python keeps a copy of an extension module's names, from which it would recreate it.
        if type(each) is dict and each.get("__name__") == "_pyodide_core":
            _empty(each)
        # What made those modules holds on to the JavaScript they were made of.
        elif _is_route(str(type(each).__module__)):
            names = getattr(each, "__dict__", None)
            if type(names) is dict:
                _empty(names)
    importlib.invalidate_caches()


def _empty(names: dict[str, Any]) -> None:
    """Remove modules, functions written in C and JavaScript's objects; Pyodide uses the others."""
    for name, value in list(names.items()):
        if isinstance(value, ModuleType | BuiltinFunctionType) or _is_of_javascript(value):
            del names[name]


def _is_of_javascript(value: object) -> bool:
    """Is it one of JavaScript's objects? Their classes have many names, and one ancestor."""
    return any(each.__name__ == "JsProxy" for each in type(value).__mro__)
