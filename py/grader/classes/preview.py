"""What learners will be told: programs of a task, marked, for the authors' page of `npm run dev`.

May import: the standard library, `grader`.

    python -m grader.classes.preview LESSONS SLUG TASK FILE…

A FILE is named from the task's folder, `wrong/one-too-many.py`. Prints a line of JSON for each as
soon as it is marked, whichever is ready first:

    {"file", "mark", "seconds": that the marking took,
     "run": null | {"place": {"world", "seed"}, "trace"}: the run that shows where it failed,
     "causes": [{"text", "hint", "line": null | of check.py}, …]: those that the check declared}

or {"file", "trouble": text} where there is no mark.
"""

from __future__ import annotations

import ast
import atexit
import json
import sys
import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from functools import cache
from pathlib import Path
from typing import Any

from grader.declare import Mistake, noting_mistakes
from grader.lesson import CourseError, TaskFolder, lesson_at
from grader.marking import Performer, mark_program
from grader.marks import first_failed
from grader.parts import PartError, compose

__all__ = ["main"]

_PROCESSES = 2


def main(lessons: Path, slug: str, task: str, files: Sequence[str]) -> None:
    """Mark and print."""
    lesson_at(lessons / slug).task(task)  # tells whoever asks for another
    with ProcessPoolExecutor(_PROCESSES) as pool:
        jobs = [pool.submit(_told, lessons / slug, task, file) for file in files]
        for done in as_completed(jobs):
            print(json.dumps(done.result()), flush=True)


# -- in a process of its own -----------------------------------------------------


@cache
def _performer() -> Performer:
    performer = Performer()
    atexit.register(performer.close)
    return performer


def _told(path: Path, name: str, file: str) -> dict[str, Any]:
    lesson = lesson_at(path)
    task = lesson.task(name)
    try:
        program = _complete(task, file)
    except (OSError, UnicodeDecodeError, PartError) as error:
        return {"file": file, "trouble": str(error)}
    check = task.check.read_text("utf-8")
    performed: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {}

    def perform(job: dict[str, Any], source: str) -> dict[str, Any]:
        result = _performer().perform(job, source)
        performed[job["id"]] = job, result
        return result

    began = time.perf_counter()
    with noting_mistakes() as found:
        mark = mark_program(check, lesson.for_judge(), name, program, perform)
    seconds = round(time.perf_counter() - began, 2)
    failed = first_failed(mark)
    where = failed["where"] if failed else None
    run = _run(*performed[where["job"]]) if where and where["job"] in performed else None
    causes = _causes(found, check) if mark["ours"] is None else []
    return {"file": file, "mark": mark, "seconds": seconds, "run": run, "causes": causes}


def _complete(task: TaskFolder, file: str) -> str:
    text = (task.path / file).read_text("utf-8")
    if not file.startswith("right/"):
        return text
    return compose(task.starter.read_text("utf-8"), text)


def _run(job: dict[str, Any], result: dict[str, Any]) -> dict[str, Any] | None:
    if job["kind"] != "run" or result["trace"] is None:
        return None
    place = {"world": job["world"], "seed": job["seed"]}
    return {"place": place, "trace": result["trace"]}


def _causes(declared: Sequence[Mistake], check: str) -> list[dict[str, Any]]:
    """The causes that a check.py can tell, as far as its text has them in full."""
    tree = ast.parse(check)
    constants = [node for node in ast.walk(tree) if isinstance(node, ast.Constant)]
    lines = {node.value: node.lineno for node in reversed(constants)}
    causes = {each.text: each.hint for each in declared}
    for node in ast.walk(tree):
        if isinstance(node, ast.Call):
            named = {each.arg: each.value for each in node.keywords}
            likely, hint = named.get("likely"), named.get("hint")
            if isinstance(likely, ast.Constant) and isinstance(likely.value, str):
                value = hint.value if isinstance(hint, ast.Constant) else None
                causes.setdefault(likely.value, value if isinstance(value, int) else None)
    return [{"text": text, "hint": hint, "line": lines.get(text)} for text, hint in causes.items()]


if __name__ == "__main__":
    try:
        main(Path(sys.argv[1]), sys.argv[2], sys.argv[3], sys.argv[4:])
    except CourseError as error:
        sys.exit(f"grader: {error}")
