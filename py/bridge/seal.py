"""Takes Python's roads to JavaScript away, once the interpreter is up and before a program runs.

The other half is the worker's (`site/src/worker/seal-python.ts`): without `_ctypes` and
`_pyodide_core` in the interpreter's table of built-in modules, nothing of this can be had again.
Neither half is what keeps a program in: that is the worker's bare JavaScript. A program should not
get that far all the same.
"""

from __future__ import annotations

import gc
import importlib
import sys
from collections.abc import Sequence
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any

__all__ = ["seal"]

_ROADS = frozenset(
    {"js", "pyodide", "pyodide_js", "_pyodide", "_pyodide_core", "ctypes", "_ctypes"}
)
"""Modules that lead to JavaScript or to the interpreter's own memory, by their first name."""


def _is_road(name: str) -> bool:
    return name.partition(".")[0] in _ROADS


class _NotHere:
    """Refuses the imports of those modules, in words that a learner understands."""

    def find_spec(
        self, name: str, _path: Sequence[str] | None = None, _target: ModuleType | None = None
    ) -> ModuleSpec | None:
        if _is_road(name):
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)
        return None


def seal() -> None:
    """Forget the modules that lead out, and empty them for whoever still holds one."""
    from _pyodide._importhook import jsfinder  # type: ignore[import-not-found]

    jsfinder.jsproxies.clear()
    ours: Any = _NotHere()
    kept = [finder for finder in sys.meta_path if not _is_road(getattr(finder, "__module__", ""))]
    sys.meta_path[:] = [ours, *kept]
    for name in [name for name in sys.modules if _is_road(name)]:
        module: Any = sys.modules.pop(name)
        if isinstance(module, ModuleType):
            _empty(vars(module))
    # Python keeps a copy of what an extension module held when it was new, to make it again.
    for each in gc.get_objects():
        if type(each) is dict and each.get("__name__") == "_pyodide_core":
            _empty(each)
    importlib.invalidate_caches()


def _empty(names: dict[str, Any]) -> None:
    """Without functions and modules; Pyodide's own C code uses the other objects, unseen."""
    for name, value in list(names.items()):
        if isinstance(value, ModuleType) or (callable(value) and not isinstance(value, type)):
            del names[name]
