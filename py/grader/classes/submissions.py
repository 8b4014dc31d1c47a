"""Which files of a folder are whose, and for which task; reads one.

May import: the standard library, `grader.lesson`.

    FOLDER/LEARNER/TASK.py
    FOLDER/LEARNER/LESSON/TASK.py      where two lessons have a task of that name
    FOLDER/LEARNER--TASK.py
    FOLDER/LEARNER.py                  with --task, where all files are for one task

The folder comes from learners: nothing outside it is read (a link is not followed), and a name that
does not fit is told, never guessed.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from difflib import get_close_matches
from pathlib import Path

from grader.lesson import CourseError, Lesson, TaskFolder

__all__ = ["Found", "Stray", "Submission", "UnreadableError", "find", "read_program"]

MOST_BYTES = 1_000_000
"""A larger file is no program."""

_LIKE_THIS = "call it LEARNER/TASK.py or LEARNER--TASK.py"
_NOT_OURS = {"__MACOSX", "__pycache__"}


class UnreadableError(Exception):
    """A submission that is no text of a program; the message says why and what to do."""


@dataclass(frozen=True, slots=True)
class Submission:
    """A file, whose it is, and what for."""

    learner: str
    lesson: Lesson
    task: TaskFolder
    path: Path
    name: str
    """The path from the class's folder, as reports show it."""


@dataclass(frozen=True, slots=True)
class Stray:
    """A file that is not marked, and why."""

    name: str
    why: str


@dataclass(slots=True)
class Found:
    """What a folder holds."""

    submissions: list[Submission] = field(default_factory=list)
    strays: list[Stray] = field(default_factory=list)
    left_out: int = 0
    """Files of tasks that were not asked for."""


def find(
    folder: Path, lessons: Iterable[Lesson], *, lesson: str | None = None, task: str | None = None
) -> Found:
    """Go through a class's folder; `lesson` and `task` say that only those are asked for.

    Raises CourseError if the folder can't be read, or the lesson or task does not exist.
    """
    return _Finder(list(lessons), lesson, task).through(folder)


class _Finder:
    def __init__(self, lessons: list[Lesson], lesson: str | None, task: str | None) -> None:
        self._slugs = [each.slug for each in lessons]
        if lesson is not None and lesson not in self._slugs:
            raise CourseError(f"there is no lesson {lesson!r}; there are: {_listed(self._slugs)}")
        self._tasks: dict[str, list[tuple[Lesson, TaskFolder]]] = {}
        for one in lessons:
            for each in one.tasks:
                self._tasks.setdefault(each.name, []).append((one, each))
        if task is not None and task not in self._tasks:
            raise CourseError(f"there is no task {task!r}; there are: {_listed(self._tasks)}")
        self._lesson = lesson
        self._task = task
        self._found = Found()
        self._taken: dict[tuple[str, str, str], str] = {}

    def through(self, folder: Path) -> Found:
        if not folder.is_dir():
            raise CourseError(f"{folder} is no folder: name the one that holds the class's files")
        for name in self._files(folder):
            self._place(folder / name, name)
        return self._found

    def _files(self, top: Path) -> Iterator[str]:
        """The name of every file, in order; what is no plain file or can't be read is told.

        Folders that wait are kept in a list: however deep they lie in each other, none is too deep.
        """
        waiting = [entry.name for entry in reversed(self._entries(top, ""))]
        while waiting:
            name = waiting.pop()
            try:
                kind = os.lstat(top / name).st_mode
            except OSError as error:
                self._stray(name, f"can't be read: {error.strerror}")
                continue
            if stat.S_ISDIR(kind):
                inside = self._entries(top, name)
                waiting += [f"{name}/{entry.name}" for entry in reversed(inside)]
            elif stat.S_ISREG(kind):
                yield name
            else:
                self._stray(name, "no plain file: links are not read")

    def _entries(self, top: Path, name: str) -> list[os.DirEntry[str]]:
        try:
            with os.scandir(top / name) as entries:
                kept = [each for each in entries if not _is_left_out(each.name)]
        except OSError as error:
            if not name:
                raise CourseError(f"{top} can't be read: {error.strerror}") from None
            self._stray(name, f"can't be read: {error.strerror}")
            return []
        return sorted(kept, key=lambda entry: entry.name)

    def _place(self, path: Path, name: str) -> None:
        *folders, file = name.split("/")
        stem, suffix = os.path.splitext(file)
        if suffix != ".py":
            return self._stray(name, "no .py file")
        if len(folders) == 0:
            learner, between, task = stem.rpartition("--")
            if between == "" and self._task is not None:
                learner, task = stem, self._task
            if not learner or not task:
                return self._stray(name, f"whose file, and for which task? {_LIKE_THIS}")
            return self._put(path, name, learner, task, None)
        if len(folders) == 1:
            return self._put(path, name, folders[0], stem, None)
        if len(folders) == 2:
            return self._put(path, name, folders[0], stem, folders[1])
        return self._stray(name, f"too many folders: {_LIKE_THIS}")

    def _put(self, path: Path, name: str, learner: str, task: str, slug: str | None) -> None:
        if slug is not None and slug not in self._slugs:
            return self._stray(name, f"no lesson is called {slug!r}{_nearest(slug, self._slugs)}")
        known = self._tasks.get(task, [])
        if not known:
            return self._stray(name, f"no task is called {task!r}{_nearest(task, self._tasks)}")
        fitting = [each for each in known if slug in (None, each[0].slug)]
        if not fitting:
            return self._stray(name, f"{slug} has no task {task!r}; {known[0][0].slug} has")
        asked = [each for each in fitting if self._lesson in (None, each[0].slug)]
        if not asked or self._task not in (None, task):
            self._found.left_out += 1
            return None
        if len(asked) > 1:
            where = _listed(each[0].slug for each in asked)
            return self._stray(
                name, f"{where} have a task {task!r}: call it LEARNER/LESSON/{task}.py"
            )
        lesson, folder = asked[0]
        key = (learner, lesson.slug, task)
        if key in self._taken:
            return self._stray(name, f"{learner} has this task in {self._taken[key]} already")
        self._taken[key] = name
        self._found.submissions.append(Submission(learner, lesson, folder, path, name))
        return None

    def _stray(self, name: str, why: str) -> None:
        self._found.strays.append(Stray(name, why))


def _is_left_out(name: str) -> bool:
    return name.startswith(".") or name in _NOT_OURS


def read_program(path: Path) -> str:
    """The text of a submission; raises UnreadableError if it is none."""
    try:
        with path.open("rb") as file:
            data = file.read(MOST_BYTES + 1)
    except OSError as error:
        raise UnreadableError(f"the file can't be read: {error.strerror}") from None
    if len(data) > MOST_BYTES:
        raise UnreadableError("the file is larger than 1 MB: is it a program?")
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise UnreadableError("the file is written in UTF-16: save it as UTF-8")
    if b"\0" in data:
        raise UnreadableError("the file holds zero bytes: it is no text")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        byte = data[error.start]
        raise UnreadableError(
            f"the file is not written in UTF-8 (byte 0x{byte:02x} on line {line}): save it as UTF-8"
        ) from None
    if not text.strip():
        raise UnreadableError("the file is empty")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _nearest(name: str, known: Iterable[str]) -> str:
    close = get_close_matches(name, list(known), n=1)
    return f"; the nearest is {close[0]!r}" if close else ""


def _listed(names: Iterable[str]) -> str:
    return ", ".join(names) or "none"
