"""All mutants of some tasks, tried on all cores; what is known from before is not tried again.

May import: the standard library, `grader.lesson`, `grader.marking`, `grader.marks`,
`grader.mutants`.

A verdict is kept as soon as it is known, under a hash of all that went into it: the mutant, its
starter and check.py, the worlds, the sources of robot, mapper and grader, and the versions of
Python and NumPy.
"""

from __future__ import annotations

import atexit
import json
import sys
from collections.abc import Iterable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import cache
from hashlib import sha256
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from random import Random
from time import perf_counter

from grader.lesson import CourseError, Fault, Lesson, TaskFolder, lesson_at
from grader.marking import Performer
from grader.marks import first_failed
from grader.mutants.equivalent import entries_of, explained
from grader.mutants.mutants import Mutant, mutants_of, own_lines
from grader.mutants.trying import BrokenCheckError, Trying, Usual, for_task

__all__ = ["Study", "sample", "studies_of", "study_all"]

PY = Path(__file__).resolve().parents[2]
CACHE = PY.parent / ".cache" / "mutants"

_PACKAGES = ("bugbot", "mapping", "performer", "grader")
_NOT_MARKING = (
    *("grader/classes/", "grader/mutants/", "grader/__main__.py", "grader/cli.py"),
    *("grader/lesson.py", "grader/report.py", "grader/schema.py", "grader/standing.py"),
    *("bugbot/__main__.py", "bugbot/cli.py", "bugbot/picture.py", "bugbot/plain_text.py"),
    *("bugbot/shut_in.py", "bugbot/supervisor.py"),
)


@dataclass(slots=True)
class Study:
    """The mutants of one task and what became of them."""

    lesson: Lesson
    task: TaskFolder
    mutants: list[Mutant]
    every: bool = True
    """Are these all mutants of the task, and not a sample?"""
    tried: dict[Mutant, bool] = field(default_factory=dict)
    """Those that are known: does it pass?"""
    reasons: dict[Mutant, str] = field(default_factory=dict)
    faults: list[Fault] = field(default_factory=list)
    seconds: float = 0.0
    """How long the marking took, on however many cores, added up."""

    @property
    def name(self) -> str:
        """Lesson and task, as the report has them."""
        return f"{self.lesson.slug}/{self.task.name}"

    @property
    def killed(self) -> int:
        """How many fail, as they should."""
        return sum(not passes for passes in self.tried.values())

    @property
    def open(self) -> list[Mutant]:
        """Those that pass without a reason."""
        return [each for each in self.mutants if self.tried.get(each) and each not in self.reasons]


def studies_of(folder: Path, slugs: Iterable[str], task: str | None = None) -> list[Study]:
    """The tasks of these lessons with their mutants, not tried yet."""
    studies = []
    for slug in slugs:
        lesson = lesson_at(folder / slug)
        tasks = lesson.tasks if task is None else [lesson.task(task)]
        for each in tasks:
            solution = each.solution.read_text("utf-8")
            lines = own_lines(each.starter.read_text("utf-8"), solution)
            if not lines:
                words = "the starter's code around the learner's part is not there unchanged"
                raise CourseError(f"{each.solution}: {words}")
            studies.append(Study(lesson, each, mutants_of(solution, lines)))
    return studies


def sample(studies: list[Study], count: int, seed: int) -> None:
    """Leave only so many mutants of all, the same for the same seed."""
    every = [(study, mutant) for study in studies for mutant in study.mutants]
    if count >= len(every):
        return
    chosen = Random(seed).sample(range(len(every)), count)
    for study in studies:
        study.mutants, study.every = [], False
    for place in sorted(chosen):
        study, mutant = every[place]
        study.mutants.append(mutant)


def study_all(studies: list[Study], processes: int) -> Iterator[Study]:
    """Try all mutants; each study is handed back when it is done, in order."""
    kept = [_Kept(study) for study in studies]
    pairs = list(zip(studies, kept, strict=True))
    pool = ProcessPoolExecutor(processes)
    try:
        # All work is handed out first, so that no core waits for the end of a task.
        solutions = {
            study.name: pool.submit(_solution, study.lesson.path, study.task.name)
            for study, known in pairs
            if study.every and known.wanting()
        }
        begun: list[dict[str, Future[_Verdict]]] = []
        for study, known in pairs:
            usual: Usual = {}
            if study.name in solutions:
                told, usual = solutions[study.name].result()
                study.seconds = sum(usual.values())
                if told is not None:
                    study.faults.append(Fault(study.task.solution, None, told))
            begun.append({} if study.faults else _begin(study, known, usual, pool))
        for (study, known), verdicts in zip(pairs, begun, strict=True):
            if not study.faults:
                _gather(study, known, verdicts)
                _explain(study)
            yield study
    finally:
        pool.shutdown(cancel_futures=True)  # after Ctrl-C as well


_Verdict = tuple[bool | None, str, float]
"""Does it pass, or what is wrong with the check.py; and after how many seconds is that known?"""


def _begin(
    study: Study, known: _Kept, usual: Usual, pool: ProcessPoolExecutor
) -> dict[str, Future[_Verdict]]:
    path, task = study.lesson.path, study.task.name
    return {
        known.key(each): pool.submit(_passes, path, task, usual, each.program)
        for each in known.wanting()
    }


def _gather(study: Study, known: _Kept, begun: dict[str, Future[_Verdict]]) -> None:
    for key, future in begun.items():
        passes, broken, seconds = future.result()
        study.seconds += seconds
        if passes is None:
            change = next(each.change for each in study.mutants if known.key(each) == key)
            words = f"it can't judge the solution changed so: {change}\n{broken}"
            study.faults.append(Fault(study.task.check, None, words))
        else:
            known.verdicts[key] = passes
            known.write()  # a study may be ended at any time, and goes on from there
    keys = {each: known.key(each) for each in study.mutants}
    study.tried = {each: known.verdicts[key] for each, key in keys.items() if key in known.verdicts}


def _explain(study: Study) -> None:
    entries, faults = entries_of(study.task.path)
    passing = [each for each in study.mutants if study.tried.get(each)]
    study.reasons, useless = explained(study.task.path, entries, study.mutants, passing)
    # Of a sample nobody can say which entries are of no use.
    study.faults += faults + (useless if study.every else [])


# -- in a process of its own -----------------------------------------------------


@cache
def _performer() -> Performer:
    performer = Performer()
    atexit.register(performer.close)
    return performer


@cache
def _lesson(path: Path) -> Lesson:
    return lesson_at(path)


def _solution(path: Path, task: str) -> tuple[str | None, Usual]:
    """What is wrong with the solution, if anything; and how long its jobs took."""
    lesson = _lesson(path)
    folder = lesson.task(task)
    program = folder.solution.read_text("utf-8")
    mark, usual = Trying(lesson, folder, _performer()).mark_solution(program)
    if mark["ours"] is not None:
        return f"marking it failed: {mark['ours']}", usual
    failed = first_failed(mark)
    if failed is not None:
        return f"the solution fails: {failed['title']}: {failed['got']}", usual
    return None, usual


def _passes(path: Path, task: str, usual: Usual, program: str) -> _Verdict:
    began = perf_counter()
    lesson = _lesson(path)
    trying = Trying(lesson, lesson.task(task), _performer())
    try:
        return trying.passes(program, usual), "", perf_counter() - began
    except BrokenCheckError as error:
        return None, str(error), perf_counter() - began


# -- what is kept ----------------------------------------------------------------


class _Kept:
    """The verdicts on one task's mutants that are known from before."""

    def __init__(self, study: Study) -> None:
        self._study = study
        self._path = CACHE / study.lesson.slug / f"{study.task.name}.json"
        task = study.task
        lesson = json.dumps(for_task(study.lesson, task), sort_keys=True)
        self._all = f"{_sources()}\0{task.check.read_text('utf-8')}\0{lesson}\0"
        self._keys = {each: self._key_of(each) for each in study.mutants}
        self.verdicts: dict[str, bool] = {}
        try:
            kept = json.loads(self._path.read_text("utf-8"))
            self.verdicts = {str(key): bool(passes) for key, passes in kept.items()}
        except (OSError, ValueError, AttributeError):
            pass  # there is none, or it is damaged: then everything is tried anew

    def key(self, mutant: Mutant) -> str:
        """Made of all that the verdict depends on."""
        return self._keys[mutant]

    def _key_of(self, mutant: Mutant) -> str:
        return sha256((self._all + mutant.program).encode()).hexdigest()[:24]

    def wanting(self) -> list[Mutant]:
        """The mutants that have to be tried."""
        return [each for each in self._study.mutants if self.key(each) not in self.verdicts]

    def write(self) -> None:
        """Keep the verdicts on these mutants; after a sample, those on others as well."""
        keys = set(self._keys.values())
        verdicts = {
            key: passes
            for key, passes in self.verdicts.items()
            if key in keys or not self._study.every
        }
        self._path.parent.mkdir(parents=True, exist_ok=True)
        # Beside it first: one who ends the study meanwhile must not leave half a file.
        beside = self._path.with_suffix(".new")
        beside.write_text(json.dumps(verdicts), "utf-8")
        beside.replace(self._path)


@cache
def _sources() -> str:
    digest = sha256(f"{sys.version} {_numpy()}".encode())
    for package in _PACKAGES:
        of_package = (PY / package).rglob("*")
        for path in sorted(each for each in of_package if each.suffix in (".py", ".json")):
            name = path.relative_to(PY).as_posix()
            if not name.startswith(_NOT_MARKING) or name == "grader/mutants/trying.py":
                digest.update(name.encode() + path.read_bytes())
    return digest.hexdigest()


def _numpy() -> str:
    try:
        return version("numpy")
    except PackageNotFoundError:
        return "none"
