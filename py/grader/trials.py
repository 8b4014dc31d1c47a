"""A trial: a run that is reported whatever comes of it, with figures, limits and points.

May import: the standard library, `mapping`, the rest of `grader`.

An expectation of a run ends its check when it is not met. One of a trial does not: it is noted,
and the trial's other figures are taken as well, so that a learner sees all the runs of a project
side by side. The first that is not met is the check's failure, once the check is through.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any

from grader.declare import Scoring
from grader.failures import AuthorError, CheckFailed, ProgramFailed
from grader.maps import Map
from grader.runs import Run
from mapping.reasons import Untrue

__all__ = ["Trial"]

_NO_LIMIT = float("inf")
_MOST_DIGITS = 3


class Trial:
    """One of a check's runs. Its methods return the trial, and are the figures' order.

    run      the run itself, for values: `grader.runs.Run`
    seed     of its noise
    layers   those that hold its map: {"free": name, "occupied": name}
    known    log odds of the beams that a cell must be beyond to count as known
    drawn    the map; None if there is none to look at
    figures  as a mark has them, in the order they were asked for
    """

    def __init__(
        self,
        run: Run,
        layers: dict[str, str],
        scored: Scoring | None,
        *,
        alone: bool,
        known: float = 0.0,
    ) -> None:
        self.run = run
        self.seed: int = run.place["seed"]
        self.layers = layers
        self.figures: list[dict[str, Any]] = []
        self.scoring = scored
        self._alone = alone
        self._known = known
        # Slips are looked for once, in the failure that is told: each look makes maps.
        self._plain = run.with_mistakes(())
        self._why: str | None = None
        self._failures: list[CheckFailed] = []
        if run.ending.trouble is not None:
            self._failures.append(run.ending.trouble)
        self.drawn = self._map_drawn()

    # -- figures, and the limits they have to keep -----------------------------------

    def known(self, at_least: float | None = None, at_most: float | None = None) -> Trial:
        """How much of the mat is known, by the word of the run's beams [%]."""
        return self._of_map(
            "known",
            lambda drawn: drawn.known_percent,
            lambda drawn: drawn.known(_or(at_least, 0.0), _or(at_most, 100.0)),
            at_least,
            at_most,
        )

    def wrong_walls(self, at_most: float | None = None) -> Trial:
        """How many of the occupied cells have nothing real near [%]."""
        return self._of_map(
            "wrong walls",
            lambda drawn: drawn.score.wrong_walls_percent,
            lambda drawn: drawn.wrong_walls(_or(at_most, 100.0)),
            None,
            at_most,
        )

    def wrong_floor(self, at_most: float | None = None) -> Trial:
        """How many of the free cells are inside something solid [%]."""
        return self._of_map(
            "wrong floor",
            lambda drawn: drawn.score.wrong_floor_percent,
            lambda drawn: drawn.wrong_floor(_or(at_most, 100.0)),
            None,
            at_most,
        )

    def walls_found(self, at_least: float | None = None) -> Trial:
        """How many of the surfaces that its beams have met are on the map [%]."""
        return self._of_map(
            "walls found",
            lambda drawn: drawn.walls_found_percent,
            lambda drawn: drawn.walls_found(_or(at_least, 0.0)),
            at_least,
            None,
        )

    def unsupported(self, at_most: float | None = None) -> Trial:
        """How much of the mat is drawn as known though its beams don't say so [%]."""
        return self._of_map(
            "unsupported",
            lambda drawn: drawn.unsupported_percent,
            lambda drawn: drawn.unsupported_cells(_or(at_most, 100.0)),
            None,
            at_most,
        )

    def took(self, at_most: float | None = None) -> Trial:
        """How long the run took [simulated s]."""
        self._expect(lambda run: run.took(_or(at_most, _NO_LIMIT)))
        return self._add("time", self._value(lambda run: run.seconds), "s", None, at_most, 1)

    def drove(self, at_most: float | None = None) -> Trial:
        """How long its path is [cm]."""
        self._expect(lambda run: run.drove(_or(at_most, _NO_LIMIT)))
        return self._add(
            "distance", self._value(lambda run: run.distance_cm), "cm", None, at_most, 0
        )

    def bumps(self, at_most: int | None = None) -> Trial:
        """How often the robot touched something."""
        if at_most is not None:
            self._expect(lambda run: run.bumped(at_most))
        return self._add("bumps", self._value(lambda run: run.bumps), "", None, at_most, 0)

    def figure(
        self,
        name: str,
        value: Callable[[Run, Map], float],
        unit: str = "",
        at_least: float | None = None,
        at_most: float | None = None,
        digits: int = 1,
    ) -> Trial:
        """A figure of the check's own.

        value   (run, map) -> number
        digits  after the point
        """
        found: float | None = None
        if self.drawn is not None:
            try:
                found = float(value(self._plain, self.drawn))
            except CheckFailed as failure:
                self._failures.append(failure)
        self._add(name, found, unit, at_least, at_most, digits)
        if found is not None and self.figures[-1]["met"] is False:
            least = "" if at_least is None else f"at least {at_least:g} {unit}"
            most = "" if at_most is None else f"at most {at_most:g} {unit}"
            words = " and ".join(each.strip() for each in (least, most) if each)
            self._failures.append(
                self._plain.failure(f"{name}: {words}", f"{found:.{digits}f} {unit}".strip())
            )
        return self

    def says_why(
        self, after: str, holds: Callable[[str, Run, Map], Untrue | None] | None = None
    ) -> Trial:
        """Expect the program to print, after this text, why it stops.

        holds  (what it said, run, map) -> None, or what is not so: a reason has to be true as well
        """
        said = [line.split(after, 1)[1] for line in self.run.console.splitlines() if after in line]
        reasons = [each.strip(" :") for each in said if each.strip(" :")]
        if not reasons:
            self._expect(lambda run: _unsaid(run, after))
            return self
        why = self._why = reasons[-1]
        drawn = self.drawn
        if holds is not None and drawn is not None and self.run.ending.kind == "finished":
            self._expect(lambda run: _must_hold(run, drawn, why, holds(why, run, drawn)))
        return self

    # -- for the judge -----------------------------------------------------------

    def must_have_done_well(self) -> None:
        """Refuse a trial in which something was not as expected."""
        if not self.failures:
            return
        first = self.run.explained(self.failures[0])
        if self._alone or isinstance(first, ProgramFailed):
            raise first
        raise first.but(got=f"{first.got} (seed {self.seed})")

    @cached_property
    def failures(self) -> list[CheckFailed]:
        """All that is not as expected; what is not backed by evidence comes last."""
        return [*self._failures, *([] if self._unseen is None else [self._unseen])]

    @cached_property
    def points(self) -> float | None:
        """What the run is worth; None if its check does not say."""
        if self.scoring is None:
            return None
        sound = self.run.ending.kind == "finished" and self._unseen is None
        if not sound or self.drawn is None:
            return 0.0
        try:
            points = float(self.scoring.points(self._plain, self.drawn))
        except CheckFailed:
            return 0.0
        if points != points:
            raise AuthorError("the points of a run are no number (NaN)")
        return round(min(max(points, 0.0), self.scoring.of), 1)

    @property
    def why(self) -> str:
        """Why the run stopped, as the program or whatever ended it says."""
        trouble = self.run.ending.trouble
        if trouble is not None:
            return trouble.got
        if self._why is not None:
            return self._why
        printed = self.run.console.strip().splitlines()
        return printed[-1] if printed else "its last line was reached"

    # -- inside ------------------------------------------------------------------

    def _map_drawn(self) -> Map | None:
        """The map; None if there is none to look at."""
        if not self.run.is_honest:
            return None
        try:
            free, occupied = self.layers["free"], self.layers["occupied"]
            return self._plain.map(None, free, occupied, self._known)
        except CheckFailed as failure:
            self._failures.append(failure)
            return None

    @cached_property
    def _unseen(self) -> CheckFailed | None:
        """What is wrong with the map's evidence."""
        try:
            if self.drawn is not None:
                self.drawn.must_have_been_seen()
        except CheckFailed as failure:
            return failure
        return None

    def _of_map(
        self,
        name: str,
        value: Callable[[Map], float],
        expectation: Callable[[Map], object],
        at_least: float | None,
        at_most: float | None,
    ) -> Trial:
        drawn = self.drawn
        if drawn is None:
            return self._add(name, None, "%", at_least, at_most, 1)
        self._expect(lambda _: expectation(drawn))
        return self._add(name, value(drawn), "%", at_least, at_most, 1)

    def _value(self, value: Callable[[Run], float]) -> float | None:
        return value(self.run) if self.run.is_honest else None

    def _expect(self, expectation: Callable[[Run], object]) -> None:
        if not self.run.is_honest:
            return
        try:
            expectation(self._plain)
        except CheckFailed as failure:
            self._failures.append(failure)

    def _add(
        self,
        name: str,
        value: float | None,
        unit: str,
        at_least: float | None,
        at_most: float | None,
        digits: int,
    ) -> Trial:
        met: bool | None = None
        if at_least is not None or at_most is not None:
            met = value is not None and _or(at_least, -_NO_LIMIT) <= value <= _or(
                at_most, _NO_LIMIT
            )
        if value is not None and met is False:
            # 84.96 must not be shown as the 85.0 that it fails to reach.
            while digits < _MOST_DIGITS and round(value, digits) in (at_least, at_most):
                digits += 1
        self.figures.append(
            {
                "name": name,
                "value": None if value is None else round(value, _MOST_DIGITS),
                "unit": unit,
                "digits": digits,
                "at_least": at_least,
                "at_most": at_most,
                "met": met,
            }
        )
        return self


def _or(limit: float | None, otherwise: float) -> float:
    return otherwise if limit is None else limit


def _unsaid(run: Run, after: str) -> None:
    raise run.failure(f"a printed line that says why it stops, after {after!r}", run.last_printed)


def _must_hold(run: Run, drawn: Map, why: str, wrong: Untrue | None) -> None:
    if wrong is not None:
        raise run.failure(
            f"a reason that is true: {wrong.wanted}",
            f'"{why[:80]}", but {wrong.found}',
            cells=[drawn.grid.cell(index) for index in wrong.cells],
            cell_cm=drawn.grid.cell_cm,
            seconds=run.seconds,
        )
