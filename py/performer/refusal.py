"""Reads a program before it is marked, and says on which line it uses what it may not.

May import: the standard library, `bugbot`, `performer.fence`.

It closes the ways from a program to the interpreter round it: modules that lead out of it, names
with two underscores that lead from a call to its module, frames, code made from text.
"""

from __future__ import annotations

import ast
import re
import sys
from typing import Any

import bugbot
from performer.fence import ALLOWED, why_not

__all__ = ["refusal"]

_LONGEST_PROGRAM = 200_000
"""Characters."""

_NAMES = frozenset(("exec", "eval", "compile", "globals", "locals", "vars"))
_LITERAL_ONLY = frozenset(("getattr", "setattr", "delattr", "hasattr"))
_ATTRIBUTES = frozenset(
    (
        "attrgetter",
        "ctypeslib",
        "Formatter",
        "ForwardRef",
        "f_back",
        "f_builtins",
        "f_code",
        "f_globals",
        "f_locals",
        "fromfile",
        "get_type_hints",
        "gi_frame",
        "cr_frame",
        "ag_frame",
        "loadtxt",
        "memmap",
        "methodcaller",
        "modules",
        "mro",
        "tb_frame",
        "tb_next",
        "genfromtxt",
    )
)
_PLAIN_DUNDERS = frozenset(
    [
        "__init__",
        "__post_init__",
        "__name__",
        "__doc__",
        "__len__",
        "__iter__",
        "__next__",
        "__getitem__",
        "__setitem__",
        "__contains__",
        "__eq__",
        "__ne__",
        "__lt__",
        "__le__",
        "__gt__",
        "__ge__",
        "__hash__",
        "__repr__",
        "__str__",
        "__bool__",
        "__add__",
        "__sub__",
        "__mul__",
        "__truediv__",
        "__floordiv__",
        "__mod__",
        "__neg__",
        "__abs__",
        "__radd__",
        "__rmul__",
        "__call__",
        "__enter__",
        "__exit__",
        "__slots__",
        "__all__",
        "__main__",
        "__future__",
        "__index__",
        "__int__",
        "__float__",
    ]
)
_DUNDER = re.compile(r"__\w+?__")


def refusal(program: str) -> str | None:
    """Why the program will not be run, naming the line; None if it will.

    A program that can't be read as Python is let through: running it says what is wrong.
    """
    if len(program) > _LONGEST_PROGRAM:
        return f"the program is longer than {_LONGEST_PROGRAM:,} characters"
    try:
        tree = ast.parse(program.removeprefix("\ufeff"))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    try:
        finder = _Finder()
        finder.visit(tree)
    except RecursionError:
        return "the program is nested too deeply to be read"
    return min(finder.found)[1] if finder.found else None


class _Finder(ast.NodeVisitor):
    """Gathers what is not allowed, as (line, sentence)."""

    def __init__(self) -> None:
        self.found: list[tuple[int, str]] = []
        self._modules: dict[str, str] = {}
        """Name in the program -> module that it stands for."""

    def _refuse(self, node: Any, what: str) -> None:
        self.found.append((node.lineno, f"line {node.lineno}: {what}"))

    # -- imports -------------------------------------------------------------

    def visit_Import(self, node: ast.Import) -> None:
        for alias in node.names:
            self._module(node, alias.name)
            name = alias.asname or alias.name.partition(".")[0]
            self._modules[name] = alias.name if alias.asname else name

    def visit_ImportFrom(self, node: ast.ImportFrom) -> None:
        module = node.module or ""
        if node.level or not self._module(node, module):
            return
        for alias in node.names:
            if alias.name != "*":
                self._part_of_module(node, module, alias.name)
                self._modules.setdefault(alias.asname or alias.name, f"{module}.{alias.name}")

    def _module(self, node: ast.AST, name: str) -> bool:
        reason = why_not(name)
        if reason is not None:
            self._refuse(node, reason)
        return reason is None

    def _part_of_module(self, node: ast.AST, module: str, part: str) -> None:
        root = module.partition(".")[0]
        if module == "bugbot" and part not in bugbot.__all__:
            self._refuse(node, f"bugbot has no call {part!r} that a program may use")
        elif part in _ATTRIBUTES or part.startswith("_"):
            self._refuse(node, f"while it is marked a program can't use {part!r} of {module}")
        elif part in _closed_parts(root):
            self._refuse(node, f"while it is marked a program can't use {module}.{part}")

    # -- names and attributes ------------------------------------------------

    def visit_Name(self, node: ast.Name) -> None:
        name = node.id
        if name in _NAMES:
            self._refuse(node, f"while it is marked a program can't use the name {name}")
        elif name in _LITERAL_ONLY:
            self._refuse(node, f"while it is marked {name}() must be called with a name in quotes")
        elif _is_inner(name):
            self._refuse(node, f"while it is marked a program can't use {name}")

    def visit_Call(self, node: ast.Call) -> None:
        called = node.func
        if isinstance(called, ast.Name) and called.id in _LITERAL_ONLY and len(node.args) > 1:
            name = node.args[1]
            if isinstance(name, ast.Constant) and isinstance(name.value, str):
                self._attribute(node, name.value)
                for each in (*node.args, *node.keywords):
                    self.visit(each)
                return
        self.generic_visit(node)

    def visit_Attribute(self, node: ast.Attribute) -> None:
        self._attribute(node, node.attr)
        base = node.value
        if isinstance(base, ast.Name) and base.id in self._modules:
            self._part_of_module(node, self._modules[base.id], node.attr)
        self.generic_visit(node)

    def visit_MatchClass(self, node: ast.MatchClass) -> None:
        for name in node.kwd_attrs:
            self._attribute(node, name)
        self.generic_visit(node)

    def _attribute(self, node: Any, name: str) -> None:
        if _is_inner(name) or name in _ATTRIBUTES:
            self._refuse(node, f"while it is marked a program can't use .{name}")

    def visit_Constant(self, node: ast.Constant) -> None:
        if isinstance(node.value, str):
            inner = [each for each in _DUNDER.findall(node.value) if _is_inner(each)]
            if inner:
                self._refuse(node, f"while it is marked a program can't use {inner[0]} in a text")


def _closed_parts(root: str) -> frozenset[str]:
    """Names of modules that can be reached through another one, as random.os can."""
    if root == "numpy":  # where select and trace are honest functions
        return frozenset(("os", "sys", "f2py", "testing", "distutils"))
    return sys.stdlib_module_names - frozenset(ALLOWED)


def _is_inner(name: str) -> bool:
    return bool(_DUNDER.fullmatch(name)) and name not in _PLAIN_DUNDERS
