"""What stands in a learner's program, so that no cause is told that the program contradicts.

May import: the standard library, `grader.parts`.

A program is read, never run. What counts is what the learner has written: of a function its body
and whatever of the program it uses, of a run the entire program, in both without the given code
around it.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache

from grader.parts import lines_written

__all__ = ["Definition", "Source", "Text"]

Definition = ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda

_SIGNS: dict[type[ast.AST], str] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.FloorDiv: "//",
    ast.Mod: "%",
    ast.Pow: "**",
    ast.BitXor: "^",
    ast.BitAnd: "&",
    ast.BitOr: "|",
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Eq: "==",
    ast.NotEq: "!=",
    ast.And: "and",
    ast.Or: "or",
    ast.Not: "not",
    ast.In: "in",
}


@dataclass(frozen=True, slots=True)
class Source:
    """A program that is marked, and the starter it was made from, if that is known."""

    program: str
    starter: str = ""

    def of(self, function: str | None = None) -> Text:
        """What the learner has written, of one function or of all the program."""
        return _text(self.program, function, self.starter)


@lru_cache(maxsize=64)
def _text(program: str, function: str | None, starter: str) -> Text:
    return Text(program, function, starter)


class Text:
    """A program, or one function of it with all that it uses, as the learner has written it."""

    def __init__(self, program: str, function: str | None = None, starter: str = "") -> None:
        self.function: Definition | None = None
        """The function itself, if the program defines it in so many words."""
        self._parts: list[ast.AST] = []
        self._aliases: dict[str, str] = {}
        self._lines = lines_written(starter, program)
        self._first = starter
        self._name = function
        try:
            tree = ast.parse(program.removeprefix("\ufeff"))
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            return
        self._aliases = _aliases(tree)
        defined = _defined(tree)
        start = defined.get(function or "")
        self.function = start if isinstance(start, Definition) else None
        self._parts = [tree] if start is None else list(_reached(start, defined))

    @cached_property
    def nodes(self) -> tuple[ast.AST, ...]:
        """All that the learner has written, without the annotations of types."""
        return tuple(
            node for part in self._parts for node, line in _walk(part, 0) if line in self._lines
        )

    @cached_property
    def definitions(self) -> tuple[Definition, ...]:
        """The function and those of the program that it uses."""
        return tuple(each for each in self._parts if isinstance(each, Definition))

    @property
    def begin(self) -> ast.AST | None:
        """What gives the function its name: its definition, or a line like f = np.vectorize(g)."""
        return self._parts[0] if self._parts else None

    def is_written(self, node: ast.AST) -> bool:
        """Whether the learner has written what begins here."""
        return getattr(node, "lineno", 0) in self._lines

    @cached_property
    def stored(self) -> frozenset[str]:
        """The names that are given a value, parameters among them."""
        names = {n.id for n in self._names(ast.Store)}
        return frozenset(names | {n.arg for n in self.nodes if isinstance(n, ast.arg)})

    @cached_property
    def names(self) -> frozenset[str]:
        """The names that are read."""
        return frozenset(self._aliases.get(n.id, n.id) for n in self._names(ast.Load))

    @cached_property
    def called(self) -> frozenset[str]:
        """The names of all that is called, or handed on as in map(int, …); of math.floor floor."""
        named = {_called(node) for node in self.nodes if isinstance(node, ast.Call)}
        named |= {n.attr for n in self.nodes if isinstance(n, ast.Attribute)}
        named |= {n.id for n in self._names(ast.Load)} - self.stored
        return frozenset(self._aliases.get(each, each) for each in named)

    @cached_property
    def signs(self) -> frozenset[str]:
        """The operators that are used, each += as + as well."""
        return frozenset(_SIGNS[type(node)] for node in self.nodes if type(node) in _SIGNS)

    @cached_property
    def numbers(self) -> frozenset[float]:
        """The numbers that are typed in."""
        constants = (node.value for node in self.nodes if isinstance(node, ast.Constant))
        return frozenset(
            each
            for each in constants
            if isinstance(each, int | float) and not isinstance(each, bool)
        )

    @property
    def returns_a_value(self) -> bool:
        """Whether the function has a `return` with something after it; True if nobody can say."""
        if self.function is None or isinstance(self.function, ast.Lambda):
            return True
        return any(
            isinstance(node, ast.Return) and node.value is not None for node in self.own_nodes()
        )

    @cached_property
    def is_begun(self) -> bool:
        """Whether the learner has changed it, into more than a `return` of a fixed value."""
        return not self.is_untouched and any(not isinstance(n, _NOTHING) for n in self.nodes)

    @cached_property
    def is_untouched(self) -> bool:
        """Whether it is still as it was in the starter."""
        return bool(self._first) and self._dump() == Text(self._first, self._name)._dump()

    def _dump(self) -> str:
        return "".join(map(ast.dump, self._parts if self.function is None else [self.function]))

    def own_nodes(self) -> Iterator[ast.AST]:
        """The nodes of the function, without those of functions inside it."""
        body = self.function.body if self.function is not None else []
        waiting: list[ast.AST] = list(body) if isinstance(body, list) else [body]
        while waiting:
            node = waiting.pop()
            yield node
            if not isinstance(node, Definition | ast.ClassDef):
                waiting += ast.iter_child_nodes(node)

    def _names(self, how: type[ast.expr_context]) -> Iterator[ast.Name]:
        return (n for n in self.nodes if isinstance(n, ast.Name) and isinstance(n.ctx, how))


_NOTHING = (
    ast.Module, ast.FunctionDef, ast.arguments, ast.arg, ast.Pass, ast.Return, ast.Constant,
    ast.Expr, ast.expr_context, ast.Tuple, ast.List, ast.Dict, ast.UnaryOp, ast.USub,
)  # fmt: skip


def _walk(node: ast.AST, line: int) -> Iterator[tuple[ast.AST, int]]:
    """A node and all inside it, each with the line on which it begins."""
    waiting = [(node, line)]
    while waiting:
        node, line = waiting.pop()
        line = getattr(node, "lineno", line)
        yield node, line
        for name, value in ast.iter_fields(node):
            if name not in ("annotation", "returns"):
                each = value if isinstance(value, list) else [value]
                waiting += [(child, line) for child in each if isinstance(child, ast.AST)]


def _called(node: ast.Call) -> str:
    function = node.func
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


def _aliases(tree: ast.Module) -> dict[str, str]:
    """Its name in the program: what it is called where it was imported from."""
    imports = [each for each in ast.walk(tree) if isinstance(each, ast.ImportFrom)]
    return {name.asname: name.name for each in imports for name in each.names if name.asname}


def _defined(tree: ast.Module) -> dict[str, ast.AST]:
    """What gives each name its meaning: a function, wherever it is, or a line at the top."""
    found: dict[str, ast.AST] = {}
    for statement in tree.body:
        if isinstance(statement, ast.Assign | ast.AnnAssign | ast.AugAssign):
            for node in ast.walk(statement):
                if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
                    found[node.id] = statement
    for each in ast.walk(tree):
        if isinstance(each, ast.FunctionDef | ast.AsyncFunctionDef):
            found[each.name] = each
        elif isinstance(each, ast.Assign) and isinstance(each.value, ast.Lambda):
            found.update({to.id: each.value for to in each.targets if isinstance(to, ast.Name)})
    return found


def _reached(start: ast.AST, defined: dict[str, ast.AST]) -> Iterator[ast.AST]:
    """A part of the program, and every other whose name stands in it, and so on."""
    seen: set[int] = set()
    waiting = [start]
    while waiting:
        node = waiting.pop()
        if id(node) in seen:
            continue
        seen.add(id(node))
        yield node
        names = {n.id for n in ast.walk(node) if isinstance(n, ast.Name)}
        names |= {n.attr for n in ast.walk(node) if isinstance(n, ast.Attribute)}
        waiting += [defined[name] for name in sorted(names) if name in defined]
