"""Executes a check.py, without ever running the learner's program: asks for jobs, gives the mark.

May import: the standard library, the rest of `grader`.

`step` knows nothing from one time to the next. It goes through all the checks with the results
that are at hand; a check that needs one more stops there, and once all have been gone
through, the jobs that are wanting are handed out. With their results everything is done again from
the start. Checks are deterministic and cheap, so that is right, and no state has to be kept or
trusted. One round does for most files, two for the rest.
"""

from __future__ import annotations

import traceback
from typing import Any

from grader.asking import Answered
from grader.declare import Check, checks_of
from grader.failures import (
    AuthorError,
    CheckFailed,
    NeedsJob,
    NotRun,
    ProgramFailed,
    ShowingFailed,
)
from grader.jobs import Desk
from grader.marks import NOT_RUN, PASSED, entry, failed_entry, mark_of
from grader.results import result_of, score_of
from grader.task import Task
from grader.text import Source
from grader.untouched import NOTHING_WRITTEN, is_untouched
from performer.refusal import refusal

__all__ = ["fails_already", "first_failure", "step"]

_MOST_ROUNDS = 8
"""Results of more jobs than this many times the checks: they are not deterministic."""


def step(
    check_source: str,
    lesson: dict[str, Any],
    task: str,
    program: str,
    results: list[Any],
    *,
    shift: int = 0,
    kept: dict[str, Any] | None = None,
) -> dict[str, Any]:
    """Go on with a marking: {"jobs": […]} if more is needed, else {"mark": …}.

    check_source  text of the task's check.py
    lesson        {"slug": …, "worlds": {name: data of the world}}, the lesson's own worlds; and
                  "starters": {task: text}, if they are known
    task          the task's name
    program       the learner's program
    results       of the jobs done so far, in any order
    shift         added to every seed, for marking the same on other noise
    kept          a dict to hand in each time that saves reading the same runs anew; it is filled

    Never raises: what goes wrong with the check.py is told in the mark, as our fault.
    """
    slug = str(lesson.get("slug"))
    filename = f"lessons/{slug}/{task}/check.py"
    try:
        checks = checks_of(check_source, filename)
    except Exception as error:
        return {"mark": mark_of(slug, task, [], ours=_ours(error, filename))}
    refused = refusal(program)
    if refused is not None:
        trouble = ProgramFailed(
            "a program that keeps to what the marking allows", refused, likely=None
        )
        entries = [failed_entry(checks[0].title, trouble, checks[0].hint)]
        entries += [entry(each.title, NOT_RUN) for each in checks[1:]]
        return {"mark": mark_of(slug, task, entries)}
    desk = _desk(lesson, task, program, results, shift, kept)
    try:
        states = [_begin(each, desk) for each in checks]
        jobs = desk.wanted()
        if jobs:
            if len(results) > _MOST_ROUNDS * (len(checks) + 1):
                raise AuthorError("its checks ask for something else each time they are run")
            return {"jobs": jobs}
        entries = _judged(checks, states, desk.source)
        trials = [(place, each) for place, (at, *_) in enumerate(states) for each in at.trials_made]
        results = [result_of(trial, place) for place, trial in trials]
        score = score_of([trial for _, trial in trials])
        return {"mark": mark_of(slug, task, entries, results=results, score=score)}
    except Exception as error:
        entries = [entry(each.title, NOT_RUN) for each in checks]
        return {"mark": mark_of(slug, task, entries, ours=_ours(error, filename))}


def fails_already(
    check_source: str,
    lesson: dict[str, Any],
    task: str,
    program: str,
    results: list[Any],
    *,
    kept: dict[str, Any] | None = None,
) -> bool:
    """Is there a check that fails whatever else comes, by the runs there are so far?

    What goes wrong with the check.py is no answer: `step` tells it.
    """
    try:
        checks = checks_of(check_source, f"lessons/{lesson.get('slug')}/{task}/check.py")
        desk = _desk(lesson, task, program, results, kept=kept)
        for begun, failure, _ in [_begin(each, desk) for each in checks]:
            if failure is not None:
                return True
            for trial in begun.trials_made:
                trial.must_have_done_well()
    except CheckFailed:
        return True
    except Exception:
        return False
    return False


def first_failure(
    check_source: str,
    lesson: dict[str, Any],
    task: str,
    program: str,
    results: list[Any],
    *,
    shift: int = 0,
) -> dict[str, Any] | None:
    """The mark as far as the first check that fails, if the runs there are so far settle it.

    The checks after it are not run. What goes wrong with the check.py is no answer: `step`
    tells it.
    """
    slug = str(lesson.get("slug"))
    try:
        checks = checks_of(check_source, f"lessons/{slug}/{task}/check.py")
        desk = _desk(lesson, task, program, results, shift)
        states: list[_Begun] = []
        for check in checks:
            at, failure, complete = _begin(check, desk)
            if not complete:
                break
            states.append((at, failure, complete))
            if failure is not None:
                break
        entries = _judged(checks[: len(states)], states, desk.source)
    except (NeedsJob, Exception):
        return None
    for place, each in enumerate(entries):
        if each["status"] != PASSED:
            rest = [entry(check.title, NOT_RUN) for check in checks[place + 1 :]]
            return mark_of(slug, task, [*entries[: place + 1], *rest])
    return None


def _desk(
    lesson: dict[str, Any],
    task: str,
    program: str,
    results: list[Any],
    shift: int = 0,
    kept: dict[str, Any] | None = None,
) -> Desk:
    """The desk of a marking; what the learner has written is held against the starter."""
    starter = (lesson.get("starters") or {}).get(task, "")
    return Desk(lesson, results, shift, Source(program, starter), kept)


_Begun = tuple[Task, CheckFailed | None, bool]
"""A check that has been gone through; how it failed, if it did; whether it had all its runs."""


def _begin(check: Check, desk: Desk) -> _Begun:
    """Go through a check as far as the results go; its calls are gathered, not judged yet."""
    task = Task(check, desk)
    try:
        check.work(task)
    except NeedsJob:
        return task, None, False  # its calls are not complete: they are asked for when they are
    except CheckFailed as failure:
        return task, failure, True
    task.ask()
    return task, None, True


def _judged(checks: list[Check], states: list[_Begun], source: Source) -> list[dict[str, Any]]:
    untouched = is_untouched(source.program, source.starter)
    answered = [pair for task, failure, _ in states if failure is None for pair in task.answered()]
    failures = [_failure_of(task, failure, answered) for task, failure, _ in states]
    # What only shows things may break on a wrong answer: then it is the answer that counts.
    is_wrong = any(
        isinstance(each, CheckFailed) and not isinstance(each, ShowingFailed) for each in failures
    )
    told: set[str] = set()
    entries = []
    for check, failure in zip(checks, failures, strict=True):
        if failure is None or (is_wrong and isinstance(failure, ShowingFailed)):
            entries.append(entry(check.title, PASSED))
        elif isinstance(failure, NotRun) or str(failure) in told:
            entries.append(entry(check.title, NOT_RUN))
        else:
            # The same trouble of the entire program is told once, not under every check.
            told |= {str(failure)} if isinstance(failure, ProgramFailed) else set()
            cause = NOTHING_WRITTEN if untouched else failure.likely
            entries.append({**failed_entry(check.title, failure, check.hint), "likely": cause})
    return entries


def _failure_of(
    task: Task, failure: CheckFailed | None, answered: list[Answered]
) -> CheckFailed | NotRun | None:
    """How a check fails, None if it does not."""
    try:
        if failure is not None:
            raise failure
        task.judge(answered)
    except (CheckFailed, NotRun) as ended:
        return ended
    return None


def _ours(error: Exception, filename: str) -> str:
    """A fault of ours, in a sentence with the line of the check.py, if it has to do with one."""
    # Without their source: in a page, the library's own may not be there to be read.
    lines: list[int | None] = [
        line
        for frame, line in traceback.walk_tb(error.__traceback__)
        if frame.f_code.co_filename == filename
    ]
    if isinstance(error, SyntaxError) and error.filename == filename:
        lines = [error.lineno]
    where = f"{filename}, line {lines[-1]}" if lines else filename
    kind = "" if isinstance(error, AuthorError) else f"{type(error).__name__}: "
    return f"{where}: {kind}{error}"
