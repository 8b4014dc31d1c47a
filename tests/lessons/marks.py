"""Every starter, solution and wrong attempt of the course marked once: the marks as one JSON list.

`same-marks.mjs` has this done by CPython and by Pyodide. Under CPython it reads and writes files:
python marks.py WORK.json MARKS.json; in Pyodide `marks` is called. What differs is the interpreter
alone: both do each job in place, without a process of its own.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from grader.marking import mark_program
from performer.perform import perform


def marks(work: str) -> str:
    """The marks of a list of {"slug", "worlds", "task", "file", "check", "starter",
    "program"}."""
    return json.dumps(
        [
            mark_program(
                each["check"],
                {
                    "slug": each["slug"],
                    "worlds": each["worlds"],
                    "starters": {each["task"]: each["starter"]},
                },
                each["task"],
                each["program"],
                perform,
            )
            for each in json.loads(work)
        ]
    )


if __name__ == "__main__":
    source, target = map(Path, sys.argv[1:])
    target.write_text(marks(source.read_text("utf-8")), "utf-8")
