"""The marks of a class as one HTML page: to read, to print, to search.

May import: the standard library, `bugbot.errors`, `grader.classes`.

The page is one file without scripts, and its policy lets it load nothing: whatever a learner has
managed to get into a name or an answer stays text.
"""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from itertools import groupby

from bugbot.errors import counted
from grader.classes.submissions import Stray
from grader.classes.summary import STATUSES, TaskTotal
from grader.classes.work import FAILED_ROW, NOT_MARKED, PASSED_ROW, UNREADABLE, Row

__all__ = ["page_of"]

_STYLE = """
:root { color-scheme: light dark; --line: #8886; --soft: #8881; }
body { font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 75rem; }
body { padding: 0 1rem; }
table { border-collapse: collapse; margin: 1rem 0; }
th, td { border: 1px solid var(--line); padding: .25rem .6rem; }
th, td { text-align: left; vertical-align: top; }
thead th { background: var(--soft); }
.wide { overflow-x: auto; }
td.passed { background: #2a8a3f2e; }
td.failed { background: #c77a0030; }
td.unreadable, td.not-marked { background: #c0262630; }
pre { white-space: pre-wrap; overflow-wrap: anywhere; margin: 0; font-size: .9em; }
section { break-inside: avoid; }
dt { font-weight: 600; }
dd { margin: 0 0 .3rem 1.2rem; }
"""

_POLICY = "default-src 'none'; style-src 'unsafe-inline'"


def page_of(
    rows: Sequence[Row], totals: Sequence[TaskTotal], strays: Sequence[Stray], about: Sequence[str]
) -> str:
    """The page; rows by learner, `about` a few lines on what was marked and how."""
    parts = [
        "<h1>Marks of a class</h1>",
        *(f"<p>{escape(line)}</p>" for line in about),
        *(["<h2>Who has passed what</h2>", _grid(rows, totals)] if rows else []),
        *(["<h2>Task by task</h2>", *(_total(each) for each in totals)] if totals else []),
        *_strays(strays),
        *_details(rows),
    ]
    return (
        '<!doctype html>\n<html lang="en-GB">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>Marks of a class</title>\n<style>{_STYLE}</style>\n</head>\n<body>\n"
        + "\n".join(parts)
        + "\n</body>\n</html>\n"
    )


def _grid(rows: Sequence[Row], totals: Sequence[TaskTotal]) -> str:
    tasks = [(each.lesson, each.task) for each in totals]
    lessons = [(lesson, len(list(group))) for lesson, group in groupby(tasks, lambda task: task[0])]
    top = "".join(f'<th colspan="{width}">{escape(lesson)}</th>' for lesson, width in lessons)
    head = "".join(f'<th scope="col">{escape(task)}</th>' for _, task in tasks)
    body = []
    for learner, group in groupby(rows, lambda row: row["learner"]):
        own = {(row["lesson"], row["task"]): row for row in group}
        cells = "".join(_cell(own.get(task)) for task in tasks)
        body.append(f'<tr><th scope="row">{escape(learner)}</th>{cells}</tr>')
    passed = "".join(
        f"<td>{each.count[PASSED_ROW]} of {each.count.total()} passed</td>" for each in totals
    )
    return (
        f'<div class="wide"><table><thead><tr><th rowspan="2">Learner</th>{top}</tr>'
        f"<tr>{head}</tr></thead><tbody>{''.join(body)}</tbody>"
        f'<tfoot><tr><th scope="row">All</th>{passed}</tr></tfoot></table></div>'
    )


def _cell(row: Row | None) -> str:
    if row is None:
        return "<td>—</td>"
    score = row["score"]
    words = {
        PASSED_ROW: "passed",
        FAILED_ROW: f"{row['passed']} of {counted(row['of'], 'check')}",
        UNREADABLE: "unreadable",
        NOT_MARKED: "not marked",
    }[row["status"]]
    points = "" if score is None else f", {score['value']:g} of {score['of']:g} points"
    return f'<td class="{row["status"].replace(" ", "-")}">{words}{points}</td>'


def _total(total: TaskTotal) -> str:
    counts = ", ".join(f"{total.count[each]} {each}" for each in STATUSES if total.count[each])
    parts = [f"<h3>{escape(total.lesson)}: {escape(total.task)}</h3>", f"<p>{counts}.</p>"]
    if total.mistakes:
        lines = "".join(
            f"<tr><td>{len(each.learners)}</td><td><pre>{escape(each.words)}</pre></td>"
            f"<td>{escape(', '.join(each.learners))}</td></tr>"
            for each in total.mistakes
        )
        parts.append(
            '<table><thead><tr><th scope="col">How many</th>'
            '<th scope="col">The commonest mistakes</th><th scope="col">Who</th></tr></thead>'
            f"<tbody>{lines}</tbody></table>"
        )
    return f"<section>{''.join(parts)}</section>"


def _strays(strays: Sequence[Stray]) -> list[str]:
    if not strays:
        return []
    lines = "".join(
        f"<tr><td>{escape(each.name)}</td><td>{escape(each.why)}</td></tr>" for each in strays
    )
    head = '<thead><tr><th scope="col">File</th><th scope="col">Why not</th></tr></thead>'
    return [
        "<h2>Files that were not marked</h2>",
        f"<table>{head}<tbody>{lines}</tbody></table>",
    ]


def _details(rows: Sequence[Row]) -> list[str]:
    parts = []
    for learner, group in groupby(rows, lambda row: row["learner"]):
        wanting = [row for row in group if row["status"] != PASSED_ROW]
        if wanting:
            told = "".join(_told(row) for row in wanting)
            parts.append(f"<section><h3>{escape(learner)}</h3>{told}</section>")
    return ["<h2>What each check said</h2>", *parts] if parts else []


def _told(row: Row) -> str:
    head = f"<h4>{escape(row['task'])} <small>({escape(row['file'])})</small></h4>"
    if row["note"] is not None:
        ours = "" if row["status"] == UNREADABLE else "No fault of the learner's: "
        return f"{head}<p>{escape(ours + row['note'])}</p>"
    return head + "".join(_failure(row, index) for index in range(len(row["failed"])))


def _failure(row: Row, index: int) -> str:
    check = row["failed"][index]
    lines = [("Expected", check["expected"]), ("Got", check["got"])]
    if check["likely"] is not None:
        lines.append(("Likely mistake", check["likely"]))
    if check["hint"] is not None:
        lines.append(("Helps", f"hint {check['hint'] + 1}"))
    told = "".join(f"<dt>{name}</dt><dd><pre>{escape(text)}</pre></dd>" for name, text in lines)
    return f"<p>Check failed: {escape(check['title'])}</p><dl>{told}</dl>"
