"""Where on the mat a learner's answer is wrong: cells to outline.

May import: the standard library, `bugbot.frames`, `grader.compare`, `performer.values`.
"""

from __future__ import annotations

from typing import Any

from bugbot.frames import cell_centre, cells_across
from grader.compare import Compare
from performer.values import shown

__all__ = ["cells_in", "grid_difference", "where_cells"]

Cell = tuple[int, int]

_MOST_CELLS = 400
"""More outlines than this tell nobody more."""


def where_cells(
    cell_cm: float | None, cells: list[Cell], world: dict[str, Any]
) -> dict[str, Any] | None:
    """The `where` of a mark for answers that are cells or grids; None for all others."""
    if cell_cm is None:
        return None
    return {
        "world": world,
        "cells": [list(cell) for cell in cells[:_MOST_CELLS]],
        "cell_cm": cell_cm,
        "seconds": None,
        "job": None,
    }


def cells_in(answer: Any) -> set[Cell]:
    """The cells in an answer: one (column, row), or several in a list or set.

    >>> sorted(cells_in([(1, 2), [(3, 4)]]))
    [(1, 2), (3, 4)]
    """
    is_row = isinstance(answer, list | tuple)
    if is_row and len(answer) == 2 and all(type(each) is int for each in answer):
        return {(answer[0], answer[1])}
    if isinstance(answer, list | tuple | set | frozenset):
        return {cell for each in answer for cell in cells_in(each)}
    return set()


def grid_difference(
    compare: Compare, grid_cm: float, right: Any, value: Any
) -> tuple[str, str, list[Cell]] | None:
    """The first cell in which two grids differ, in words, and all such cells; None if no grids."""
    across = cells_across(grid_cm)
    expected, got = _flat(right, across), _flat(value, across)
    if expected is None or got is None:
        return None
    differing = [
        index for index, pair in enumerate(zip(expected, got, strict=True)) if not compare(*pair)
    ]
    if not differing:
        return None
    cells = [(index % across, index // across) for index in differing]
    x, y = cell_centre(*cells[0], grid_cm)
    more = len(cells) - 1
    others = f"; {more} more cell{'s differ' if more > 1 else ' differs'}" if more else ""
    return (
        f"{shown(expected[differing[0]])} in the cell in column {cells[0][0]}, "
        f"row {cells[0][1]}, around ({x:g}, {y:g})",
        f"{shown(got[differing[0]])}{others}",
        cells,
    )


def _flat(grid: Any, across: int) -> list[Any] | None:
    """A grid as a flat list, row after row, whether it is one already or a list of rows."""
    if not isinstance(grid, list | tuple):
        return None
    if len(grid) == across and all(isinstance(row, list | tuple) for row in grid):
        grid = [each for row in grid for each in row]
    return list(grid) if len(grid) == across * across else None
