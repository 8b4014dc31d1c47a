"""From an exception to what the learner is told: which line, what, and why perhaps.

May import: the standard library, `bugbot.errors`, `bugbot.trace`, `bugbot.run.slips`.

Only the frames of the learner's own file are ever shown: the rest is our business.
The traceback is put together here, in one plain form, because Python's own changes
from version to version and the browser's is not the one of the command line.
"""

from __future__ import annotations

import re
from collections import ChainMap
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType

import bugbot
from bugbot.errors import BugbotError, counted, with_article
from bugbot.run.slips import likely_cause
from bugbot.run.slips.arguments import plain_arguments
from bugbot.run.slips.case import Case, lines_of
from bugbot.trace import storable

__all__ = ["Fault", "fault_of", "learner_lines"]

_LONGEST_MESSAGE = 2000
_LONGEST_LINE = 200
_FRAMES_SHOWN = 10
"""So many frames are shown at either end of a long traceback."""

_OURS = str(Path(bugbot.__file__).parent)


@dataclass(frozen=True, slots=True)
class Fault:
    """An error of the learner's program, in the words of a trace's `fault` event."""

    type: str
    message: str
    line: int | None
    hint: str | None
    traceback: str


def fault_of(error: BaseException, source: str, filename: str) -> Fault:
    """What to tell of this error in the program `filename` with this text."""
    case = _case(error, lines_of(source), filename)
    message = _message(case, error)
    hint = likely_cause(case)
    if _is_our_fault(error, filename):
        message = f"bugbot itself failed here, which is our fault and not yours: {message}"
        hint = None
    story = _traceback(error, case, message)
    return Fault(
        storable(_type_name(error)),
        storable(message),
        case.line,
        None if hint is None else storable(hint),
        storable(story),
    )


def learner_lines(error: BaseException, filename: str) -> list[int]:
    """The lines of the learner's file on the way to the error, outermost first."""
    return [line for line, _ in _frames(error, filename)]


# -- where ---------------------------------------------------------------------


def _walk(error: BaseException) -> Iterator[TracebackType]:
    step = error.__traceback__
    while step is not None:
        yield step
        step = step.tb_next


def _frames(error: BaseException, filename: str) -> list[tuple[int, str]]:
    """Line and function of each of the learner's frames, outermost first."""
    return [
        (step.tb_lineno, step.tb_frame.f_code.co_name)
        for step in _walk(error)
        if step.tb_frame.f_code.co_filename == filename
    ]


def _case(error: BaseException, lines: list[str], filename: str) -> Case:
    """The error as the slips look at it."""
    text = (error.msg or "") if isinstance(error, SyntaxError) else _text(error)
    text = _short(text, _LONGEST_MESSAGE)  # the patterns below take their time over longer ones
    if isinstance(error, SyntaxError) and not learner_lines(error, filename):
        line = _real_line(error.lineno or _line_with_null(lines), lines)
        return Case(error, text, line, lines, {}, filename)
    if isinstance(error, BaseExceptionGroup) and not learner_lines(error, filename):
        return _case(error.exceptions[0], lines, filename)
    scope: ChainMap[str, object] = ChainMap()
    line = None
    for step in _walk(error):
        frame = step.tb_frame
        if frame.f_code.co_filename == filename:
            line = step.tb_lineno
            scope = ChainMap(frame.f_locals, frame.f_globals)
    return Case(error, text, line, lines, scope, filename)


def _real_line(line: int | None, lines: list[str]) -> int | None:
    # Python may put an error at the end of the file one line after the last.
    return None if line is None else max(1, min(line, len(lines)))


def _line_with_null(lines: list[str]) -> int | None:
    # The one thing that Python refuses without saying where.
    return next((number for number, text in enumerate(lines, 1) if "\0" in text), None)


def _is_our_fault(error: BaseException, filename: str) -> bool:
    """Whether the error was raised in our code and is none that we raise on purpose."""
    if isinstance(error, BugbotError | RecursionError | MemoryError):
        return False
    raised_in = [step.tb_frame.f_code.co_filename for step in _walk(error)]
    return bool(raised_in) and raised_in[-1].startswith(_OURS) and filename in raised_in


# -- what ----------------------------------------------------------------------


def _type_name(error: BaseException) -> str:
    """Python's name of the error; ours go by the Python error they are a kind of."""
    kind = type(error)
    if isinstance(error, BugbotError):
        return next(
            (base.__name__ for base in kind.__mro__ if base.__module__ == "builtins"), kind.__name__
        )
    return kind.__name__


def _text(error: BaseException) -> str:
    try:
        return str(error)
    except Exception as failure:
        return f"(its own text can't be shown: {type(failure).__name__})"


_PLAIN: tuple[tuple[type[BaseException], str, str], ...] = (
    (
        RecursionError,
        r"maximum recursion depth",
        "a function went on calling itself: too many calls inside one another",
    ),
    (MemoryError, r"$", "the program wants more memory than there is"),
    (ZeroDivisionError, r".*(division|modulo)", "division by zero"),
    (SyntaxError, r"invalid syntax$", "this can't be read as Python (invalid syntax)"),
)
"""Python's own words that are bare, or differ from one version to the next, and plainer ones."""


def _message(case: Case, error: BaseException) -> str:
    if isinstance(error, BaseExceptionGroup):
        parts = "; ".join(f"{type(each).__name__}: {_text(each)}" for each in error.exceptions)
        return _short(
            f"{counted(len(error.exceptions), 'error')} at once: {parts}", _LONGEST_MESSAGE
        )
    plain = next(
        (
            words
            for kind, pattern, words in _PLAIN
            if type(error) is kind and re.match(pattern, case.message)
        ),
        None,
    )
    if plain is None:
        plain = plain_arguments(case)
    if plain is None and isinstance(error, KeyError) and len(error.args) == 1:
        plain = f"there is no key {case.message}"
    if plain is None:
        plain = re.sub(r" \(detected at line \d+\)$", "", case.message)
    return _short(plain or _without_words(error), _LONGEST_MESSAGE)


def _without_words(error: BaseException) -> str:
    if isinstance(error, AssertionError):
        return "what the assert says is not so"
    return f"{with_article(type(error).__name__)}, without a message"


def _short(text: str, longest: int) -> str:
    return text if len(text) <= longest else text[: longest - 1] + "…"


# -- the whole story -----------------------------------------------------------


def _traceback(error: BaseException, case: Case, message: str) -> str:
    blocks = [_block(error, case, message)]
    seen = {id(error)}
    while True:
        cause = error.__cause__
        if cause is None and not error.__suppress_context__:
            cause = error.__context__
        if cause is None or id(cause) in seen or len(seen) > _FRAMES_SHOWN:
            break
        link = "That error led to this one:" if error.__cause__ else "While that was handled, this:"
        seen.add(id(cause))
        earlier = _case(cause, case.lines, case.filename)
        blocks += [f"\n{link}\n\n", _block(cause, earlier, _message(earlier, cause))]
        error = cause
    return "".join(reversed(blocks))


def _block(error: BaseException, case: Case, message: str) -> str:
    frames = _frames(error, case.filename)
    if not frames and case.line is not None:
        frames = [(case.line, "<module>")]
    shown = [_frame(line, name, case) for line, name in frames[-_FRAMES_SHOWN:]]
    left_out = len(frames) - 2 * _FRAMES_SHOWN
    if left_out > 0:
        shown.insert(0, f"  … {left_out} more calls …\n")
    earlier = frames[:-_FRAMES_SHOWN][:_FRAMES_SHOWN]
    shown[:0] = [_frame(line, name, case) for line, name in earlier]
    head = "Traceback (most recent call last):\n" if shown else ""
    return f"{head}{''.join(shown)}{_type_name(error)}: {message}\n"


def _frame(line: int, name: str, case: Case) -> str:
    text = _short(case.text_of(line).strip(), _LONGEST_LINE)
    return f'  File "{case.filename}", line {line}, in {name}\n    {text}\n'
