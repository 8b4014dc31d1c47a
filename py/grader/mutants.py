"""Small changes to the learner's part of a program, such as a learner might make.

May import: the standard library.

A change is made to the syntax tree and written out again, so comments and layout don't count. It is
known by the text of the statement before and after: that survives edits elsewhere in the file.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from copy import deepcopy
from dataclasses import dataclass
from functools import partial
from typing import Any

__all__ = ["Mutant", "mutants_of"]


@dataclass(frozen=True, slots=True)
class Mutant:
    """One small change: where, the statement before and after it, and the complete program."""

    line: int
    before: str
    after: str
    program: str


def mutants_of(program: str, lines: range) -> list[Mutant]:
    """Every small change to the statements on these lines (1 is the first), each program once.

    >>> [each.after for each in mutants_of("size = width < 1", range(1, 2))]
    ['pass', 'size = width <= 1', 'size = width > 1', 'size = width < 2', 'size = width < 0']
    """
    tree = ast.parse(program)
    seen = {ast.unparse(tree)}
    found = []
    for line, before, after in _changes(tree, lines):
        text = ast.unparse(ast.fix_missing_locations(tree))
        if text not in seen and _compiles(text):
            seen.add(text)
            found.append(Mutant(line, before, after(), text))
    return found


def _compiles(text: str) -> bool:
    try:
        compile(text, "mutant", "exec", dont_inherit=True)
    except (SyntaxError, ValueError):
        return False
    return True


_Change = tuple[int, str, Callable[[], str]]


def _changes(tree: ast.Module, lines: range) -> Iterator[_Change]:
    """Makes one change after another to the tree; each is taken back before the next."""
    values = _typed_values(tree)
    for block in _blocks(tree):
        for place, statement in enumerate(block):
            if statement.lineno not in lines or _is_docstring(statement):
                continue
            yield from _of_statement(block, place, lines)
            names = {node.id for node in ast.walk(statement) if isinstance(node, ast.Name)}
            for owner, field, at, node in _expressions(statement):
                for new in _of_expression(node, names, values):
                    before = _first_line(statement)
                    _put(owner, field, at, new)
                    yield statement.lineno, before, partial(_first_line, statement)
                    _put(owner, field, at, node)


def _blocks(tree: ast.AST) -> Iterator[list[ast.stmt]]:
    for node in list(ast.walk(tree)):
        for field in ("body", "orelse", "finalbody"):
            block = getattr(node, field, None)
            if isinstance(block, list) and block and isinstance(block[0], ast.stmt):
                yield block


def _is_docstring(statement: ast.stmt) -> bool:
    return isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)


_COMPOUND = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Import, ast.ImportFrom)


def _of_statement(block: list[ast.stmt], place: int, lines: range) -> Iterator[_Change]:
    """A statement dropped, a guard dropped, two in the wrong order, a loop left after one round."""
    statement = block[place]
    if isinstance(statement, _COMPOUND):
        return
    line, before = statement.lineno, _first_line(statement)

    def told(text: str) -> _Change:
        return line, before, lambda: text

    block[place] = ast.copy_location(ast.Pass(), statement)
    yield told("pass")
    block[place] = statement
    if isinstance(statement, ast.If):
        block[place : place + 1] = statement.body
        yield told("without its if")
        block[place : place + len(statement.body)] = [statement]
    if isinstance(statement, ast.For | ast.While):
        statement.body.append(ast.Break())
        yield told("left after one round")
        statement.body.pop()
    following = block[place + 1] if place + 1 < len(block) else None
    movable = following is not None and not isinstance(following, _COMPOUND)
    if following is not None and movable and following.lineno in lines:
        block[place], block[place + 1] = following, statement
        yield told(f"after {_first_line(following)}")
        block[place], block[place + 1] = statement, following


def _first_line(statement: ast.stmt) -> str:
    return ast.unparse(statement).partition("\n")[0]


_Slot = tuple[ast.AST, str, int | None, ast.AST]


def _expressions(statement: ast.stmt) -> Iterator[_Slot]:
    """The expressions of a statement, with where each stands; not those of statements inside it."""
    waiting: list[ast.AST] = [statement]
    while waiting:
        owner = waiting.pop(0)
        for field, value in ast.iter_fields(owner):
            listed = value if isinstance(value, list) else [value]
            for at, node in enumerate(listed):
                if not isinstance(node, ast.AST) or isinstance(node, ast.stmt | ast.JoinedStr):
                    continue
                yield owner, field, at if isinstance(value, list) else None, node
                waiting.append(node)


def _put(owner: ast.AST, field: str, at: int | None, node: ast.AST) -> None:
    if at is None:
        setattr(owner, field, node)
    else:
        getattr(owner, field)[at] = node


def _typed_values(tree: ast.Module) -> dict[str, ast.Constant]:
    """The constants of the program whose value is one number."""
    found = {}
    for node in tree.body:
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant):
            for target in node.targets:
                if isinstance(target, ast.Name) and target.id.isupper():
                    found[target.id] = node.value
    return found


# -- expressions -----------------------------------------------------------------

_OPERATORS: dict[type[ast.AST], tuple[type[ast.AST], ...]] = {
    ast.Lt: (ast.LtE, ast.Gt),
    ast.LtE: (ast.Lt, ast.GtE),
    ast.Gt: (ast.GtE, ast.Lt),
    ast.GtE: (ast.Gt, ast.LtE),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
    ast.Add: (ast.Sub,),
    ast.Sub: (ast.Add,),
    ast.Mult: (ast.Div,),
    ast.Div: (ast.Mult, ast.FloorDiv),
    ast.FloorDiv: (ast.Div, ast.Mod),
    ast.Mod: (ast.FloorDiv,),
    ast.Pow: (ast.Mult,),
    ast.And: (ast.Or,),
    ast.Or: (ast.And,),
    ast.BitAnd: (ast.BitOr,),
    ast.BitOr: (ast.BitAnd,),
}
_CALLS = {
    "int": ("round",),
    "floor": ("ceil", "trunc"),
    "ceil": ("floor",),
    "round": ("int",),
    "sin": ("cos",),
    "cos": ("sin",),
    "min": ("max",),
    "max": ("min",),
    "radians": ("degrees",),
    "degrees": ("radians",),
    "append": ("extend",),
    "any": ("all",),
    "all": ("any",),
}
_LEFT_OUT = frozenset(("radians", "degrees", "abs", "int", "floor", "round", "sorted", "set"))
"""Calls of one argument that are easily forgotten."""
_PAIRS = (("x", "y"), ("dx", "dy"), ("column", "row"), ("c", "r"), ("width", "height"))
_SWAPPED = {a: b for pair in _PAIRS for a, b in (pair, pair[::-1])}


def _of_expression(
    node: ast.AST, names: set[str], values: dict[str, ast.Constant]
) -> Iterator[ast.AST]:
    for kind in _OPERATORS.get(type(node), ()):
        yield kind()
    if isinstance(node, ast.Constant) and isinstance(node.value, bool):
        yield ast.Constant(not node.value)
    elif isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        yield ast.Constant(node.value + 1)
        yield ast.Constant(node.value - 1)
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not | ast.USub):
        yield node.operand
    elif isinstance(node, ast.BoolOp):
        for at in range(len(node.values)):
            rest = node.values[:at] + node.values[at + 1 :]
            yield rest[0] if len(rest) == 1 else ast.BoolOp(node.op, rest)
    elif isinstance(node, ast.Compare) and len(node.ops) == 2:
        first, middle, last = node.left, node.comparators[0], node.comparators[1]
        yield ast.Compare(first, node.ops[:1], [middle])
        yield ast.Compare(middle, node.ops[1:], [last])
    elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
        if _SWAPPED.get(node.id) in names:
            yield ast.Name(_SWAPPED[node.id], ast.Load())
        if node.id in values:
            yield values[node.id]
    elif isinstance(node, ast.comprehension) and node.ifs:
        yield ast.comprehension(node.target, node.iter, [], node.is_async)
    elif isinstance(node, ast.Call):
        yield from _of_call(node)


def _of_call(node: ast.Call) -> Iterator[ast.AST]:
    function: Any = node.func
    name = function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")
    for other in _CALLS.get(name, ()):
        renamed = deepcopy(node)
        changed: Any = renamed.func
        setattr(changed, "attr" if isinstance(changed, ast.Attribute) else "id", other)
        yield renamed
    plain = not node.keywords and not any(isinstance(each, ast.Starred) for each in node.args)
    if len(node.args) == 1 and name in _LEFT_OUT:
        yield node.args[0]
    if len(node.args) == 2 and plain:
        yield ast.Call(node.func, node.args[::-1], [])
        if name in ("min", "max"):
            yield from node.args
    if name == "range" and plain:
        for sign in (ast.Add(), ast.Sub()):
            changed_end = ast.BinOp(node.args[min(1, len(node.args) - 1)], sign, ast.Constant(1))
            args = list(node.args)
            args[min(1, len(args) - 1)] = changed_end
            yield ast.Call(node.func, args, [])
