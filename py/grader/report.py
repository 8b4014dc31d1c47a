"""A mark as the command line prints it.

May import: the standard library, `grader.marks`.
"""

from __future__ import annotations

from typing import Any

from grader.marks import FAILED, NOT_RUN, PASSED, first_failed

__all__ = ["text_of"]

_SIGNS = {PASSED: "+", FAILED: "-", NOT_RUN: "."}
_NO_FIGURE = "-"
_NOT_MET = "*"


def text_of(mark: dict[str, Any]) -> str:
    """The mark as text: its checks, the first that failed in detail, its results."""
    lines = [f"{mark['lesson']}: {mark['task']}"]
    first = first_failed(mark)
    for each in mark["checks"]:
        lines.append(f"  {_SIGNS[each['status']]} {each['title']}: {each['status']}")
        if first is not None and each is first:
            lines += _details(first)
    lines += _table(mark["results"])
    if mark["score"] is not None:
        score = mark["score"]
        lines.append(f"  Score: {score['value']:.1f} of {score['of']:g}. {score['how']}")
    if mark["ours"] is not None:
        lines.append(f"  This is our fault, not yours: {mark['ours']}")
    lines.append("Passed." if mark["passed"] else "Not passed yet.")
    return "\n".join(lines)


def _details(check: dict[str, Any]) -> list[str]:
    lines = [_detail("expected", check["expected"]), _detail("got", check["got"])]
    where = check["where"]
    if where is not None:
        is_plain_call = where["job"] is None and where["world"]["name"] == "empty"
        parts = [] if is_plain_call else [f"world {where['world']['name']}"]
        if where["seconds"] is not None:
            parts.append(f"at {where['seconds']:.1f} s")
        if where["cells"]:
            cells = ", ".join(f"({column}, {row})" for column, row in where["cells"][:5])
            more = len(where["cells"]) - 5
            noun = "cell" if len(where["cells"]) == 1 else "cells"
            parts.append(f"{noun} {cells}{f' and {more} more' if more > 0 else ''}")
        if parts:
            lines.append(_detail("where", "; ".join(parts)))
    if check["likely"] is not None:
        lines.append(_detail("likely", check["likely"]))
    if check["hint"] is not None:
        lines.append(_detail("help", f"hint {check['hint'] + 1}"))
    return lines


def _detail(name: str, text: str) -> str:
    """A line, with what follows in it below its beginning.

    Some of it is the learner's text: no line of it may look like one of ours, and nothing in it
    may move the terminal's cursor.
    """
    plain = ["".join(c if c.isprintable() else " " for c in line) for line in text.splitlines()]
    return f"      {name + ':':<10}" + f"\n{' ' * 16}".join(plain)


# -- results ---------------------------------------------------------------------


def _table(results: list[dict[str, Any]]) -> list[str]:
    """A row for each result under a row of names; under it, what the stars stand for."""
    if not results:
        return []
    heads = {_head(figure): None for result in results for figure in result["figures"]}
    rows = [["mat", "seed", *heads, "points", "why it stopped"]]
    rows += [_row(result, list(heads)) for result in results]
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    lines = [""]
    for row in rows:
        cells = [text.rjust(width) for text, width in zip(row, widths, strict=True)]
        cells[0], cells[-1] = row[0].ljust(widths[0]), row[-1]
        lines.append(f"  {'  '.join(cells)}")
    if any(figure["met"] is False for result in results for figure in result["figures"]):
        lines.append(f"  {_NOT_MET} outside its limit")
    return [*lines, ""]


def _head(figure: dict[str, Any]) -> str:
    """What is above a column: the name, the unit, and the limits."""
    unit = f" [{figure['unit']}]" if figure["unit"] else ""
    least = "" if figure["at_least"] is None else f" >= {figure['at_least']:g}"
    most = "" if figure["at_most"] is None else f" <= {figure['at_most']:g}"
    return f"{figure['name']}{unit}{least}{most}"


def _row(result: dict[str, Any], heads: list[str]) -> list[str]:
    said = {_head(figure): _said(figure) for figure in result["figures"]}
    points = _NO_FIGURE if result["points"] is None else f"{result['points']:.1f}"
    figures = [said.get(head, _NO_FIGURE) for head in heads]
    return [result["world"]["title"], str(result["seed"]), *figures, points, result["why"]]


def _said(figure: dict[str, Any]) -> str:
    value = figure["value"]
    text = _NO_FIGURE if value is None else f"{value:.{figure['digits']}f}"
    return text + (_NOT_MET if figure["met"] is False else " ")
