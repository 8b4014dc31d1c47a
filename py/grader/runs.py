"""A run of the learner's program: what came of it, and what is expected of it.

May import: the standard library, `bugbot`, `mapping`, the rest of `grader`.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable, Iterable, Mapping
from copy import copy
from functools import cached_property
from math import hypot
from typing import Any

from bugbot.errors import counted
from bugbot.frames import wrap_heading
from bugbot.run.outcome import outcome_of
from bugbot.sim.odometry import Odometry
from bugbot.trace import Trace
from bugbot.worlds import Start, World
from grader.declare import Mistake
from grader.endings import Ending, broken_off, ending_of, where_in
from grader.failures import AuthorError, CheckFailed
from grader.jobs import died_of
from grader.lines import Line
from grader.maps import Map, drawn_map, reference_map
from grader.naming import perhaps_meant, what_there_is
from grader.scans import Scan, SeenAs, beams_of, evidence_at, mapper_of, scans_of
from grader.surfaces import surfaces_met
from grader.traces import trace_from
from grader.trust import doubt
from mapping.beam import PassedBy, Weights, passed_by_steps
from mapping.evidence import Evidence
from mapping.frontiers import State
from mapping.grid import Grid
from mapping.log_odds import KNOWN
from mapping.mapper import Mapper
from mapping.score import Rectangle
from performer.values import MalformedError

__all__ = ["Run"]

_END = float("inf")


class Run:
    """One run on one world with one seed. Everything is read from its trace.

    seconds    simulated seconds it took
    start      where the robot stood at first (x, y, heading) on the mat
    obstacles  what really stands there: (x, y, width, height)
    path       [(t, x, y, heading)], the true poses
    scans      its looks, each with .t .x .y .heading .beams [(angle, reading)]
    console    all that it printed
    bumps      how often it touched something
    drift      how fast its gyro really drifted [degrees/s]
    """

    def __init__(self, job: dict[str, Any], trace: Trace | None, ending: Ending):
        self._job = job
        self._trace = trace
        self.ending = ending
        self._mistakes: tuple[Mistake, ...] = ()
        self._maps: list[Map] = []
        # Worked out once, and shared by all that look at this run.
        self._evidence: dict[tuple[float, float], Evidence] = {}
        self._surfaces: dict[tuple[float, float], Mapping[int, int]] = {}
        self._mappers: dict[tuple[Any, ...], Mapper] = {}
        self._world = World.from_dict(job["world"])
        self.start: Start = self._world.start
        self.obstacles: list[Rectangle] = [
            (each.x, each.y, each.width, each.height) for each in self._world.obstacles
        ]
        heading = wrap_heading(self.start.heading)
        drift_deg_s = self._world.odometry.drift_deg_s
        self.drift = Odometry(heading, job["seed"], drift_deg_s).drift_deg_s
        self.seconds = 0.0
        self.console = ""
        self.bumps = 0
        self._series: dict[str, list[list[float]]] = {}
        self.path: list[tuple[float, float, float, float]] = []
        self.scans: list[Scan] = []
        if trace is not None:
            outcome = outcome_of(trace)
            self.seconds = outcome["seconds"]
            self.console = outcome["console"]
            self.bumps = sum(1 for _ in trace.of_kind("bump"))
            self._series = outcome["series"]
            self.path = [event[1:5] for event in trace.events if event[0] == "pose"]
            self.scans = scans_of(trace)

    # -- for Task ------------------------------------------------------------

    @classmethod
    def of(cls, job: dict[str, Any], result: dict[str, Any]) -> Run:
        """The run that a performer reports."""
        died = died_of(result)
        if died is not None:
            return cls(job, None, broken_off(job, "a program that comes to its end", died))
        try:
            trace = trace_from(
                result.get("trace"), job["world"], job["seed"], job["limits"]["simulated_s"]
            )
        except MalformedError as error:
            words = f"the run left no record that can be read: {error}"
            return cls(job, None, broken_off(job, "a run of the robot", words))
        return cls(job, trace, ending_of(job, trace))

    def with_mistakes(self, mistakes: tuple[Mistake, ...]) -> Run:
        """The same run, looked at by a check that knows these mistakes."""
        run = copy(self)
        run._mistakes = mistakes
        run._maps = []
        return run

    @cached_property
    def is_honest(self) -> bool:
        """Whether there is a record, even of a run cut short, of what can have happened."""
        if self._trace is None or self.ending.kind == "doubted":
            return False
        return self.ending.kind == "finished" or doubt(self._trace, self._world) is None

    @property
    def place(self) -> dict[str, Any]:
        """Where it was made, as a mark says it."""
        return {"world": self._job["world"], "seed": self._job["number"], "job": self._job["id"]}

    def must_have_ended(self) -> None:
        """Refuse a run that did not come to its end, or can't have been."""
        trouble = self.ending.trouble
        if trouble is not None:
            raise self.explained(trouble)

    def must_have_seen_its_maps(self) -> None:
        """Refuse maps, among those looked at, of cells where no beam has been."""
        for each in self._maps:
            each.must_have_been_seen()

    def failure(
        self,
        expected: str,
        got: str,
        *,
        cells: Iterable[tuple[int, int]] = (),
        cell_cm: float = 5.0,
        seconds: float | None = None,
        likely: str | None = None,
        hint: int | None = None,
    ) -> CheckFailed:
        """A failed expectation about this run, with the slip that it looks like."""
        failure = CheckFailed(
            expected,
            got,
            likely=likely,
            hint=hint,
            where=where_in(self._job, seconds, cells, cell_cm),
        )
        return self.explained(failure)

    def explained(self, failure: CheckFailed) -> CheckFailed:
        """The failure with the mistake that the run looks like, unless it has a cause already.

        A run that broke off is explained by what broke it off, or by a mistake about such runs.
        """
        broken_off = self.ending.kind != "finished"
        looks = failure.likely is None or broken_off
        mistake = self._mistake(broken_off=broken_off) if looks else None
        if mistake is None:
            return failure
        hint = failure.hint if mistake.hint is None else mistake.hint
        return failure.but(likely=mistake.text, hint=hint)

    @property
    def error(self) -> str:
        """The error that ended it, with its type, line and message; nothing if it was none."""
        trouble = self.ending.trouble
        return trouble.got if trouble is not None and self.ending.kind == "fault" else ""

    def _mistake(self, *, broken_off: bool) -> Mistake | None:
        plain = self.with_mistakes(())
        for mistake in self._mistakes:
            if mistake.broken_off != broken_off:
                continue
            try:
                if mistake.slip(plain):
                    return mistake
            except CheckFailed:  # it asks for a map or a line that is not there
                continue
        return None

    # -- maps ----------------------------------------------------------------

    def map(
        self,
        at: float | None = None,
        free: str = "free",
        occupied: str = "occupied",
        known: float = 0.0,
        off_by: float = 0.0,
    ) -> Map:
        """The map drawn in these two layers, at the end or at a time [s].

        known   log odds of the beams that a cell must be beyond to count as known
        off_by  how far the program's own poses may be off, if it has no camera [cm]
        """
        seconds = self.seconds if at is None else at
        layers = {free: State.FREE, occupied: State.OCCUPIED}
        drawn = drawn_map(self, layers, seconds, known, off_by)
        self._maps.append(drawn)
        return drawn

    def mapped(
        self,
        cell_cm: float = 5.0,
        weights: Weights = Weights(),  # noqa: B008 - it is frozen
        passed_by: PassedBy = passed_by_steps,
        known: float = KNOWN,
        seen_as: SeenAs | None = None,
    ) -> Map:
        """The reference's map of this run's scans, taken as they were or as a slip would."""
        key = (cell_cm, weights, passed_by, seen_as)
        if key not in self._mappers:
            self._mappers[key] = mapper_of(self.scans, *key)
        return reference_map(self, self._mappers[key], known, self.seconds)

    def evidence_at(
        self,
        x: float,
        y: float,
        cell_cm: float = 5.0,
        weights: Weights = Weights(),  # noqa: B008 - it is frozen
        passed_by: PassedBy = passed_by_steps,
        seen_as: SeenAs | None = None,
    ) -> list[tuple[float, float]]:
        """Time and log odds, at first and after each scan, of the cell that holds a point."""
        return evidence_at(self.scans, x, y, cell_cm, weights, passed_by, seen_as)

    def evidence(self, grid: Grid, seconds: float) -> Evidence:
        """What the beams of this run, up to a time, say of the cells."""
        key = (grid.cell_cm, seconds)
        if key not in self._evidence:
            self._evidence[key] = Evidence(grid, beams_of(self._scans_until(seconds)))
        return self._evidence[key]

    def surfaces(self, grid: Grid, seconds: float) -> Mapping[int, int]:
        """How many beams of this run, up to a time, really met something in each cell."""
        key = (grid.cell_cm, seconds)
        if key not in self._surfaces:
            self._surfaces[key] = surfaces_met(self._world, self._scans_until(seconds), grid)
        return self._surfaces[key]

    def _scans_until(self, seconds: float) -> list[Scan]:
        return [scan for scan in self.scans if scan.t <= seconds + 1e-6]

    def layers(self, seconds: float = _END) -> dict[str, dict[str, Any]]:
        """The layers as they were drawn last up to a time, with their points."""
        trace = self._trace
        if trace is None:
            return {}
        last = {
            event["name"]: event for event in trace.of_kind("layer") if event["t"] <= seconds + 1e-6
        }
        return {name: {**event, "points": trace.points_of(event)} for name, event in last.items()}

    def layer(self, name: str) -> list[tuple[float, float]]:
        """The points of a layer at the end; fails if it was never drawn."""
        layers = self.layers()
        if name not in layers:
            there = what_there_is("layer", "layers", layers)
            raise self.failure(f'a layer named "{name}"', there)
        points: list[tuple[float, float]] = layers[name]["points"]
        return points

    # -- chart and console ---------------------------------------------------

    def line(self, name: str) -> Line:
        """A line of the chart; fails if nothing was plotted under that name."""
        if name not in self._series:
            raise self.failure(
                f'a line named "{name}" in the chart, drawn with plot("{name}", …)',
                what_there_is("line in the chart", "lines in the chart", self._series),
                likely=perhaps_meant("line", name, self._series),
            )
        return Line(self, name, [(t, value) for t, value in self._series[name]])

    def prints(self, text: str) -> Run:
        """Expect a text in what was printed."""
        if text not in self.console:
            raise self.failure(f"a printed line with {text!r}", self.last_printed)
        return self

    def number_after(self, text: str) -> float:
        """The number printed after a text, the last one; fails if there is none.

        Blanks count as little as they do to a reader: "drift 0 :" is "drift 0:".
        """
        pattern = _with_any_blanks(text) + r"[^-+\d\n]{0,20}([-+]?\d+\.?\d*(?:[eE][-+]?\d+)?)"
        found = re.findall(pattern, self.console)
        if not found:
            raise self.failure(f"a number printed after {text!r}", self.last_printed)
        return float(found[-1])

    @property
    def last_printed(self) -> str:
        """What it printed last, as a message says it."""
        lines = self.console.strip().splitlines()
        if not lines:
            return "nothing is printed"
        return f"the last line printed is {lines[-1][:80]!r}"

    # -- driving -------------------------------------------------------------

    def visits(
        self, is_there: Callable[[float, float], object], what: str, by: float | None = None
    ) -> Run:
        """Expect the robot to come to where `is_there(x, y)` holds, by a time if need be."""
        there = next((t for t, x, y, _ in self.path if is_there(x, y)), None)
        if there is None or (by is not None and there > by):
            _, x, y, _ = self.path[-1]
            when = "" if by is None else f" within {by:g} s"
            never = f"it never got there, and ended at ({x:.0f}, {y:.0f})"
            raise self.failure(
                f"the robot to reach {what}{when}",
                never if there is None else f"it got there after {there:.1f} s",
                seconds=self.seconds,
            )
        return self

    def never_bumps(self) -> Run:
        """Expect the robot to touch nothing."""
        return self.bumped(at_most=0)

    def bumped(self, at_most: int) -> Run:
        """Expect the robot to touch something at most so many times."""
        if self._trace is not None and self.bumps > at_most:
            first = next(self._trace.of_kind("bump"))
            times = _times(self.bumps)
            raise self.failure(
                "the robot to touch nothing"
                if at_most == 0
                else f"the robot to touch something at most {_times(at_most)}",
                f"it touched something {times}, first at {first['t']:.1f} s",
                cells=[(int(first["x"] // 5), int(first["y"] // 5))],
                seconds=first["t"],
            )
        return self

    @property
    def distance_cm(self) -> float:
        """The length of its path."""
        steps = zip(self.path, self.path[1:], strict=False)
        length = 0.0
        for before, after in steps:
            length += hypot(after[1] - before[1], after[2] - before[2])
        return length

    def drove(self, at_most: float) -> Run:
        """Expect a path of at most so many centimetres."""
        driven = self.distance_cm
        if driven > at_most:
            raise self.failure(f"a path of at most {at_most:g} cm", f"{driven:.0f} cm")
        return self

    def took(self, at_most: float) -> Run:
        """Expect the run to be over after so many simulated seconds."""
        if self.seconds > at_most:
            raise self.failure(
                f"a run of at most {at_most:g} s", f"{self.seconds:.1f} s", seconds=at_most
            )
        return self

    def scanned(self, at_least: int) -> Run:
        """Expect so many looks with the depth sensor."""
        if len(self.scans) < at_least:
            raise self.failure(
                f"at least {counted(at_least, 'scan')}", counted(len(self.scans), "scan")
            )
        return self

    def pose_at(self, seconds: float) -> tuple[float, float, float]:
        """True x, y, heading of the robot at a time: the last record up to then."""
        if not self.path:
            raise AuthorError("pose_at() asks for the path of a run that has none")
        index = bisect_right([pose[0] for pose in self.path], seconds + 1e-9)
        return self.path[max(0, index - 1)][1:]


def _times(count: int) -> str:
    return "once" if count == 1 else f"{count} times"


def _with_any_blanks(text: str) -> str:
    """A pattern for the text with one blank or more where it has some, and any before its signs."""
    parts = re.findall(r"\s+|\w+|[^\w\s]", text)
    return "".join(
        r"[ \t]+" if each.isspace() else each if each.isalnum() else r"[ \t]*" + re.escape(each)
        for each in parts
    )
