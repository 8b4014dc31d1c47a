"""The work that a judge asks for, and what comes back: plain JSON both ways.

May import: the standard library, `bugbot.worlds`, `bugbot.errors`, `grader.failures`,
`grader.text`, `performer.limits`, `performer.values`.

    job      {"id", "kind": "run", "world": {…}, "seed", "number": the seed as the check names it,
              "limits": {…}}
             {"id", "kind": "calls", "limits",
              "groups": [{"world", "seed", "constants": {name: value}, "calls": […]}, …]}
    result   {"id", "trace": {"events", "points", "moves"} | null, "outcome" | null,
              "answers": [[answer, …] or …] | null, "died": null | "time" | "crash" | text}

A group is what one check asks of the learner's functions: the program is run anew for it and
its calls are made in order. All groups of a check.py go into one job. The job's id is made of
its groups' ids, and those of their contents: so a judge that starts again from nothing finds
the answers by itself.

The seeds are not those that a check names: a number made of the submission's text is added. The
same file always has the same mark, and a table of what one run has read fits no other.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass, field
from typing import Any

from bugbot import worlds
from bugbot.errors import WorldError, got, nearest
from grader.failures import AuthorError, NeedsJob
from grader.text import Source
from performer.limits import CALLS_LIMITS, RUN_LIMITS
from performer.values import encoded

__all__ = ["Desk", "Group", "died_of"]


@dataclass(slots=True)
class Group:
    """The calls of one check in one world."""

    world: dict[str, Any]
    seed: int
    constants: dict[str, Any] = field(default_factory=dict)
    """Changed in the program's text before it runs."""
    calls: list[dict[str, Any]] = field(default_factory=list)

    def to_json(self) -> dict[str, Any]:
        """As a job holds it."""
        constants = {name: encoded(value) for name, value in self.constants.items()}
        return {
            "world": self.world,
            "seed": self.seed,
            "constants": constants,
            "calls": self.calls,
        }

    @property
    def id(self) -> str:
        """Made of the contents."""
        return _digest(self.to_json())


class Desk:
    """What one pass over the checks has to hand, and what it finds wanting.

    lesson   {"slug": …, "worlds": {name: world}}: the lesson's own worlds
    results  of the jobs done so far
    shift    added to every seed: the standing check marks solutions on other noise
    source   the learner's program: its noise comes from its text, and no cause may contradict that
    noise    added to every seed as well, and to what chance draws: a number made of the program
    """

    def __init__(
        self,
        lesson: dict[str, Any],
        results: list[Any],
        shift: int = 0,
        source: Source = Source(""),  # noqa: B008 - it is frozen
        kept: dict[str, Any] | None = None,
    ) -> None:
        self.shift = shift
        self.source = source
        self.noise = _noise_of(source.program)
        self._own_worlds: dict[str, Any] = lesson.get("worlds") or {}
        self._results = {str(each.get("id")): each for each in results if isinstance(each, dict)}
        self._jobs: dict[str, dict[str, Any]] = {}
        self._groups: dict[str, Group] = {}
        self.kept: dict[str, Any] = {} if kept is None else kept
        """Room for what is made of a result, so that checks that share a run read it once."""

    def world(self, name: str) -> dict[str, Any]:
        """The data of a world of the lesson or of bugbot."""
        try:
            if name in self._own_worlds:
                data = worlds.World.from_dict(self._own_worlds[name], f"worlds/{name}.json")
                return data.to_dict()
            if name in worlds.names():
                return worlds.load(name).to_dict()
        except WorldError as error:
            raise AuthorError(str(error)) from None
        known = [*self._own_worlds, *worlds.names()]
        near = nearest(name, known) if isinstance(name, str) else None
        meant = f" (did you mean {near!r}?)" if near else ""
        raise AuthorError(f"there is no world {got(name)}{meant}; there are {', '.join(known)}")

    def seed(self, number: int) -> int:
        """The seed that stands for the one a check names, for this submission."""
        return number + self.shift + self.noise

    def run(self, world: str, seed: int, seconds: float) -> tuple[dict[str, Any], dict[str, Any]]:
        """The job of a run and its result; raises NeedsJob if that is not there yet."""
        limits = {**RUN_LIMITS, "simulated_s": float(seconds)}
        job: dict[str, Any] = {
            "kind": "run",
            "world": self.world(world),
            "seed": self.seed(seed),
            "number": seed,
            "limits": limits,
        }
        job_id = job["id"] = f"run-{_digest(job)}"
        result = self._results.get(job_id)
        if result is None:
            self._jobs[job_id] = job
            raise NeedsJob
        return job, result

    def ask(self, group: Group) -> None:
        """Have these calls made."""
        self._groups[group.id] = group

    def answers(self, group: Group) -> tuple[Any, str | None]:
        """What came back for these calls, and how their job died if it did."""
        for job_id, result in self._results.items():
            kind, *groups = job_id.split("-")
            if kind == "calls" and group.id in groups:
                answers = result.get("answers")
                place = groups.index(group.id)
                if isinstance(answers, list) and len(answers) > place:
                    return answers[place], died_of(result)
                return None, died_of(result)
        raise NeedsJob

    def wanted(self) -> list[dict[str, Any]]:
        """The jobs without which the checks can't go on."""
        missing = [group for group in self._groups.values() if not self._has(group)]
        jobs = list(self._jobs.values())
        if missing:
            name = "-".join(["calls", *(group.id for group in missing)])
            groups = [group.to_json() for group in missing]
            jobs.append({"id": name, "kind": "calls", "groups": groups, "limits": CALLS_LIMITS})
        return jobs

    def _has(self, group: Group) -> bool:
        try:
            self.answers(group)
        except NeedsJob:
            return False
        return True


_NOISES = 1_000_000
"""So many submissions can have noises of their own."""


def _noise_of(program: str) -> int:
    """The same for the same text, another for any other: what was read once is no use again.

    How a file ends its lines, a byte-order mark and empty lines at the end are no part of the text.
    """
    text = "\n".join(program.removeprefix("\ufeff").splitlines()).rstrip("\n")
    digest = hashlib.sha256(text.encode("utf-8", "surrogatepass"))
    return int.from_bytes(digest.digest()[:8], "big") % _NOISES * _APART


_APART = 100
"""Between the seeds of one submission and the next: a check names seeds below this."""


def died_of(result: dict[str, Any]) -> str | None:
    """Why a job was never finished, in words; None if it was."""
    died = result.get("died")
    if died is None:
        return None
    if died == "time":
        return (
            "it did not stop computing, so it was ended: it is very slow, or it has a loop that "
            "never ends"
        )
    if died == "crash":
        return (
            "Python itself broke down while it ran: functions that call themselves without end, "
            "or more memory than there is"
        )
    return str(died)[:500]


def _digest(data: Any) -> str:
    text = json.dumps(data, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:12]
