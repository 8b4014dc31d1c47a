"""Marks what learners write, on worlds and noise they have not seen.

May import: the standard library, `bugbot`, `performer`, `sandbox`, `mapping`.

The words of a check.py are these, and `grader.task.Task`'s methods; lessons/README.md teaches
them:

    check          names a check: @check("A point in the middle of a cell", hint=0)
    function       declares a function the learner writes, what is right, and the likely slips
    exactly        how answers are compared: as they are
    near           … numbers within so much
    between        … a number from one to another, wherever it stands in what is expected
    in_any_order   … lists whose order does not matter
    in_words       … told in words of the check's own, where several answers are right
    scoring        what a run of task.trials is worth
    mistake        a likely mistake, with what must stand in the program for it to be told:
                   calls, reads, stores, operator, number, code, loops,
                   lacks, either

How marking works. A learner's program is never run in the interpreter that judges it:

    judge.py      executes a check.py, never a program; asks for jobs, and gives the mark
    jobs.py       the JSON between it and the performer, which is a package of its own

    task.py       what a check is handed: call, set, variable, run, expect, near
    declare.py    a check.py's checks, and the functions it declares
    asking.py     what a check asks of the learner's functions
    functions.py  judges the answers
    slips.py      which mistake explains wrong ones
    text.py       what the learner has written, which a cause must not contradict
    conditions.py what must stand there for a cause to be told
    looping.py    whether a loop stands there
    places.py     where on the mat an answer is wrong
    compare.py    exactly, near, in_any_order, in_words
    runs.py       a run: its path, its chart, its prints
    endings.py    how it ended
    trials.py     runs that are all reported, whatever comes of them
    results.py    the report of each, and the score of all
    maps.py       the map a run has drawn
    scans.py      what the reference makes of a run's scans
    traces.py     a trace from elsewhere, checked row by row
    lines.py      a line of its chart
    trust.py      a trace held against the truth
    marks.py      the mark, as JSON
    report.py     the mark, as text
    failures.py   the three ways a check ends early

    lesson.py     reads a lesson's folder, and says what is wrong with it
    marking.py    the dialogue of judge and performer, under plain CPython
    parts.py      the learner's part of a program
    standing.py   the standing check of a whole course
    mutants/      holds the checks to small changes of the solutions, as a learner might make them
    cli.py        python -m grader mark …, python -m grader check …
"""

from grader.compare import between, exactly, in_any_order, in_words, near
from grader.conditions import (
    calls,
    code,
    either,
    lacks,
    loops,
    number,
    operator,
    reads,
    stores,
)
from grader.declare import check, function, mistake, scoring

__all__ = [
    "between",
    "calls",
    "check",
    "code",
    "either",
    "exactly",
    "function",
    "in_any_order",
    "in_words",
    "lacks",
    "loops",
    "mistake",
    "near",
    "number",
    "operator",
    "reads",
    "scoring",
    "stores",
]
