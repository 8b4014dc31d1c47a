"""Every mutant of a solution: the learner's part with one small change.

May import: the standard library, `grader.mutants`, `grader.parts`.
"""

from __future__ import annotations

import ast
import difflib
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain

from grader.mutants import names, operators, statements
from grader.mutants.edits import Edit, Source, Span
from grader.parts import frame_of, lines_of_part

__all__ = ["Mutant", "mutants_of", "own_lines"]

_Function = ast.FunctionDef | ast.AsyncFunctionDef


@dataclass(frozen=True, slots=True)
class Mutant:
    """A solution with one change."""

    kind: str
    function: str
    """Where the change is: a function's name, as map.of for one inside another; "" for none."""
    line: int
    """Where it is in solution.py; 1 is the first."""
    before: str
    after: str
    """The changed lines, before and afterwards, without what is around them."""
    program: str
    number: int = 1
    """Of those with the same function, before and after, the how-manieth it is."""

    @property
    def change(self) -> str:
        """The change on one line, as equivalent.json and the report have it."""
        return f"{self.before} -> {self.after}"


def own_lines(starter: str, solution: str) -> set[int]:
    """The lines of a solution that the learner writes; 1 is the first.

    Where the starter has no part marked, they are those that it does not have.
    """
    if frame_of(starter) is not None:
        return set(lines_of_part(starter, solution))
    ours, given = solution.splitlines(), starter.splitlines()
    matcher = difflib.SequenceMatcher(None, given, ours, autojunk=False)
    return {
        line + 1
        for tag, _, _, first, last in matcher.get_opcodes()
        if tag != "equal"
        for line in range(first, last)
    }


def mutants_of(solution: str, lines: set[int]) -> list[Mutant]:
    """The mutants of a program whose change begins on one of these lines, in its order.

    A change that does not read as Python, or that makes the same program, is none; of two that
    make the same program the first is kept.
    """
    source = Source(solution)
    seen = {ast.dump(source.tree)}
    made: list[Mutant] = []
    numbers: dict[tuple[str, str, str], int] = {}
    for function, edit in sorted(_edits(source, lines), key=lambda each: each[1].span):
        program = source.changed(edit)
        try:
            dumped = ast.dump(ast.parse(program))
        except SyntaxError:
            continue
        if dumped in seen:
            continue
        seen.add(dumped)
        before, after = _told(source, edit)
        key = (function, before, after)
        numbers[key] = numbers.get(key, 0) + 1
        line = source.line_of(edit.span[0])
        made.append(Mutant(edit.kind, function, line, before, after, program, numbers[key]))
    return made


def _edits(source: Source, lines: set[int]) -> Iterator[tuple[str, Edit]]:
    known = names.available(source.tree)

    def walk(node: ast.AST, function: str, scope: names.Scope) -> Iterator[tuple[str, Edit]]:
        if isinstance(node, _Function):
            function = f"{function}.{node.name}".lstrip(".")
            scope = names.Scope(source.tree, node)
        for edit in chain(
            statements.edits_of(source, node),
            operators.edits_of(source, node, known),
            names.edits_of(source, node, scope),
        ):
            if source.line_of(edit.span[0]) in lines and source.line_of(edit.span[1]) in lines:
                yield function, edit
        for child in ast.iter_child_nodes(node):
            yield from walk(child, function, scope)

    return walk(source.tree, "", names.Scope(source.tree, None))


def _told(source: Source, edit: Edit) -> tuple[str, str]:
    """The lines that the change is in, before and afterwards, each on one line."""
    start, end = _whole_lines(source, edit.span)
    before = source.text((start, end))
    after = source.text((start, edit.span[0])) + edit.text + source.text((edit.span[1], end))
    if edit.kind == "statement left out" and "\n" in before:
        return f"{before.splitlines()[0].strip()} …", "left out"
    if edit.kind == "early return":
        return before.strip(), f"{before.strip()} | break"
    return _line(before), _line(after)


def _whole_lines(source: Source, span: Span) -> Span:
    start = source.data.rfind(b"\n", 0, span[0]) + 1
    end = source.data.find(b"\n", span[1])
    return start, len(source.data) if end < 0 else end


def _line(text: str) -> str:
    return " | ".join(line.strip() for line in text.splitlines())
