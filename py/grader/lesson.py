"""Reads a lesson's folder, and says what is wrong with it.

May import: the standard library, `bugbot.errors`, `bugbot.worlds`, `grader.schema`.

    lesson.json                     checked against lessons/lesson.schema.json
    lesson.md                       prose; `::program NAME`, `::task NAME`, `::picture NAME`
    programs/*.py                   each named in lesson.json
    pictures/*.py or *.svg          each shown in lesson.md
    worlds/*.json                   worlds of this lesson alone
    <task>/starter.py solution.py check.py
    <task>/wrong/*.py               four or more, each beginning with `# earns: …`
    <task>/right/*.py               right ones in other styles, each beginning with `# style: …`
"""

from __future__ import annotations

import json
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from bugbot import worlds
from bugbot.errors import WorldError, counted
from bugbot.worlds import World
from grader.schema import Document, read

__all__ = [
    "LESSONS",
    "Attempt",
    "CourseError",
    "Fault",
    "Lesson",
    "TaskFolder",
    "course",
    "lesson_at",
    "name_of_lesson",
    "shown",
]

LESSONS = Path(__file__).resolve().parents[2] / "lessons"
"""Where the course lies."""

FEWEST_WRONG = 4
FEWEST_RIGHT = 4
"""Of a task that has any."""
_EARNS = "# earns:"
_STYLE = "# style:"
_DIRECTIVE = re.compile(r"^::(program|task|picture) +([\w-]+)", re.MULTILINE)


class CourseError(Exception):
    """The course or the lesson asked for can't be found or read at all."""


@dataclass(frozen=True, slots=True)
class Fault:
    """Something wrong in a lesson's files; shown as file:line: what."""

    file: Path
    line: int | None
    what: str

    def __str__(self) -> str:
        line = "" if self.line is None else f":{self.line}"
        return f"{shown(self.file)}{line}: {self.what}"


@dataclass(frozen=True, slots=True)
class Attempt:
    """A wrong attempt and the message it must earn."""

    path: Path
    earns: str


@dataclass(slots=True)
class TaskFolder:
    """A task as its folder and its entry in lesson.json hold it."""

    name: str
    path: Path
    line: int
    hints: int
    world: str
    wrong: list[Attempt] = field(default_factory=list)
    right: list[Path] = field(default_factory=list)
    """Right solutions in other styles; the learner's part alone, where the task has one."""

    @property
    def check(self) -> Path:
        """Its check.py."""
        return self.path / "check.py"

    @property
    def starter(self) -> Path:
        """What the learner begins with."""
        return self.path / "starter.py"

    @property
    def solution(self) -> Path:
        """What passes."""
        return self.path / "solution.py"


@dataclass(slots=True)
class Lesson:
    """A lesson's folder: its tasks, its own worlds, and what is wrong with it."""

    slug: str
    path: Path
    tasks: list[TaskFolder] = field(default_factory=list)
    worlds: dict[str, dict[str, Any]] = field(default_factory=dict)
    faults: list[Fault] = field(default_factory=list)

    def task(self, name: str) -> TaskFolder:
        """The task of that name; CourseError if there is none."""
        for each in self.tasks:
            if each.name == name:
                return each
        known = ", ".join(each.name for each in self.tasks) or "none"
        raise CourseError(f"{self.slug} has no task {name!r}; its tasks: {known}")

    def world(self, name: str) -> dict[str, Any] | None:
        """The data of a world of this lesson or of bugbot."""
        if name in self.worlds:
            return self.worlds[name]
        return worlds.load(name).to_dict() if name in worlds.names() else None

    def for_judge(self) -> dict[str, Any]:
        """The lesson as `grader.judge.step` wants it."""
        starters = {task.name: _text(task.starter) for task in self.tasks if task.starter.is_file()}
        return {"slug": self.slug, "worlds": self.worlds, "starters": starters}


def shown(path: Path) -> str:
    """A path as messages show it: from the folder that holds `lessons`."""
    try:
        return path.resolve().relative_to(LESSONS.parent).as_posix()
    except ValueError:
        return path.as_posix()


def name_of_lesson(typed: str) -> str:
    """A lesson's name as somebody typed it: shells complete it to "lessons/u8-…/"."""
    return Path(typed).name


def course(folder: Path) -> tuple[list[str], list[Fault]]:
    """The lessons of a course in order, and what is wrong with course.json."""
    path = folder / "course.json"
    schema = {
        "type": "object",
        "required": ["format", "lessons"],
        "additionalProperties": False,
        "properties": {
            "format": {"const": 1},
            "lessons": {"type": "array", "uniqueItems": True, "items": {"type": "string"}},
        },
    }
    document = read(_text(path), schema)
    faults = [Fault(path, line, what) for line, what in document.faults]
    if faults:
        return [], faults
    slugs: list[str] = document.data["lessons"]
    for index, slug in enumerate(slugs):
        if not (folder / slug / "lesson.json").exists():
            line = document.line_of("lessons", index)
            faults.append(Fault(path, line, f"there is no lesson {slug}"))
    return [slug for slug in slugs if (folder / slug / "lesson.json").exists()], faults


def _text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise CourseError(f"{shown(path)} can't be read: {error}") from None


def lesson_at(path: Path) -> Lesson:
    """Read a lesson's folder; whatever is wrong is in its `faults`."""
    if not (path / "lesson.json").exists():
        raise CourseError(f"there is no lesson in {shown(path)}: it has no lesson.json")
    return _Reader(path).lesson


class _Reader:
    """Reads one folder, and gathers what is wrong."""

    def __init__(self, path: Path) -> None:
        self.lesson = Lesson(path.name, path)
        self._path = path
        self._used = {path / name for name in ("lesson.json", "lesson.md", "figures.json")}
        schema = json.loads(_text(LESSONS / "lesson.schema.json"))
        document = read(_text(path / "lesson.json"), schema)
        self._worlds()
        for line, what in document.faults:
            self._fault(path / "lesson.json", line, what)
        if document.faults:
            return
        self._programs(document)
        self._tasks(document)
        self._prose(document)
        self._stray()

    def _fault(self, file: Path, line: int | None, what: str) -> None:
        self.lesson.faults.append(Fault(file, line, what))

    def _worlds(self) -> None:
        for path in sorted((self._path / "worlds").glob("*.json")):
            self._used.add(path)
            try:
                world = World.from_dict(json.loads(_text(path)), "the world")
            except WorldError as error:
                self._fault(path, 1, str(error))
            except ValueError as error:
                self._fault(path, getattr(error, "lineno", 1), f"this is not JSON: {error}")
            else:
                if world.name != path.stem:
                    self._fault(path, 1, f"its name is {world.name!r}, not {path.stem!r}")
                self.lesson.worlds[path.stem] = world.to_dict()

    def _known_world(self, document: Document, *at: str | int) -> None:
        data = document.data
        for part in at:
            data = data[part]
        if self.lesson.world(data) is None:
            line = document.line_of(*at)
            self._fault(self._path / "lesson.json", line, f"there is no world {data!r}")

    def _programs(self, document: Document) -> None:
        for name, entry in document.data["programs"].items():
            path = self._path / "programs" / entry.get("file", f"{name}.py")
            self._used.add(path)
            self._known_world(document, "programs", name, "world")
            if not path.exists():
                line = document.line_of("programs", name)
                self._fault(self._path / "lesson.json", line, f"{shown(path)} is missing")

    def _tasks(self, document: Document) -> None:
        for index, entry in enumerate(document.data.get("tasks", [])):
            line = document.line_of("tasks", index, "name")
            task = TaskFolder(
                entry["name"],
                self._path / entry["name"],
                line,
                len(entry["hints"]),
                entry["world"],
            )
            self._known_world(document, "tasks", index, "world")
            for number in range(len(entry.get("practice", []))):
                self._known_world(document, "tasks", index, "practice", number)
            parts = [task.starter, task.solution, task.check]
            self._used.update(parts)
            self._used.add(task.path / "equivalent.json")
            missing = [path for path in parts if not path.exists()]
            for path in missing:
                self._fault(self._path / "lesson.json", line, f"{shown(path)} is missing")
            self._wrong(task)
            self._right(task)
            if not missing:
                self.lesson.tasks.append(task)

    def _wrong(self, task: TaskFolder) -> None:
        paths = sorted((task.path / "wrong").glob("*.py"))
        self._used.update(paths)
        if len(paths) < FEWEST_WRONG:
            self._fault(
                self._path / "lesson.json",
                task.line,
                f"the task {task.name} has {counted(len(paths), 'wrong attempt')}; "
                f"{FEWEST_WRONG} are wanted",
            )
        for path in paths:
            first = _text(path).partition("\n")[0]
            earns = first.removeprefix(_EARNS).strip()
            if not first.startswith(_EARNS) or not earns:
                words = f'line 1 should be "{_EARNS} …", a part of the message that it must earn'
                self._fault(path, 1, words)
                continue
            task.wrong.append(Attempt(path, earns))

    def _right(self, task: TaskFolder) -> None:
        task.right = sorted((task.path / "right").glob("*.py"))
        self._used.update(task.right)
        if len(task.right) < FEWEST_RIGHT:
            self._fault(
                self._path / "lesson.json",
                task.line,
                f"the task {task.name} has {len(task.right)} right solutions in other styles; "
                f"{FEWEST_RIGHT} are wanted",
            )
        for path in task.right:
            first = _text(path).partition("\n")[0]
            if not first.removeprefix(_STYLE).strip() or not first.startswith(_STYLE):
                self._fault(path, 1, f'line 1 should be "{_STYLE} …", how it differs from ours')

    def _prose(self, document: Document) -> None:
        path = self._path / "lesson.md"
        if not path.exists():
            self._fault(path, None, "the file is missing: write the lesson's prose there")
            return
        text = _text(path)
        shown_in_prose: dict[str, list[str]] = {"program": [], "task": [], "picture": []}
        for match in _DIRECTIVE.finditer(text):
            kind, name = match.groups()
            shown_in_prose[kind].append(name)
        entries = document.data.get("tasks", [])
        tasks = [entry["name"] for entry in entries]
        for kind, there in (("program", list(document.data["programs"])), ("task", tasks)):
            for name in there:
                times = shown_in_prose[kind].count(name)
                # A program may be there for its figures alone; a task must be done.
                if times > 1 or (kind == "task" and times == 0):
                    words = f"the {kind} {name} stands {times} times in lesson.md; once is wanted"
                    line = document.line_of("programs", name)
                    if kind == "task":
                        line = document.line_of("tasks", tasks.index(name))
                    self._fault(self._path / "lesson.json", line, words)
        for name in shown_in_prose["picture"]:
            self._used.update(self._path / "pictures" / f"{name}{end}" for end in (".py", ".svg"))

        for name in self.lesson.worlds:
            sources = [_text(each.check) for each in self.lesson.tasks]
            named = [each["world"] for each in [*document.data["programs"].values(), *entries]]
            named += [each for entry in entries for each in entry.get("practice", [])]
            if name not in named and not any(f'"{name}"' in source for source in sources):
                self._used.discard(self._path / "worlds" / f"{name}.json")

    def _stray(self) -> None:
        for path in sorted(self._path.rglob("*")):
            if path.is_file() and "__pycache__" not in path.parts and path not in self._used:
                words = "nothing uses this file: name it in lesson.json or lesson.md, or remove it"
                self._fault(path, None, words)
